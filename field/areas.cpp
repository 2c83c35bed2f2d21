#include "field/areas.h"

#include <ogrsf_frmts.h>

#include <algorithm>

#include "field/error.h"
#include "field/gdal.h"

namespace cydonia {
namespace {

struct Driver {
    const char* name;  // as GDAL calls it
    const char* what;  // in our messages
};

Driver driver_of(VectorFormat format) {
    switch (format) {
        case VectorFormat::kGeoJson:
            return {"GeoJSON", "GeoJSON with a FeatureCollection or a Feature"};
        case VectorFormat::kShapefile:
            return {"ESRI Shapefile", "a Shapefile"};
        default:
            return {"GPKG", "a GeoPackage"};
    }
}

// Keeps the first error that GDAL reports while this object exists: later ones only say
// that something failed. Warnings are ignored.
class FirstError {
  public:
    FirstError() { CPLPushErrorHandlerEx(&keep, this); }
    ~FirstError() { CPLPopErrorHandler(); }
    FirstError(const FirstError&) = delete;
    FirstError& operator=(const FirstError&) = delete;

    const std::string& message() const { return message_; }

  private:
    static void CPL_STDCALL keep(CPLErr level, CPLErrorNum, const char* message) {
        auto& self = *static_cast<FirstError*>(CPLGetErrorHandlerUserData());
        if (level < CE_Failure || !self.message_.empty()) return;
        self.message_ = message;
        std::ranges::replace(self.message_, '\n', ' ');
    }
    std::string message_;
};

class Reader {
  public:
    Reader(const std::filesystem::path& file, std::size_t most_corners)
        : file_(file.string()), most_corners_(most_corners) {}

    std::vector<Area> areas(VectorFormat format) {
        const Dataset dataset = opened(format);
        std::vector<Area> areas;
        std::size_t number = 0;
        for (OGRLayer* layer : dataset->GetLayers()) {
            for (const auto& feature : *layer) add(*feature, ++number, areas);
        }
        if (!errors_.message().empty())
            throw bad_request("{}: {}", file_, errors_.message());
        return areas;
    }

  private:
    Dataset opened(VectorFormat format) const {
        const Driver driver = driver_of(format);
        const char* const drivers[] = {driver.name, nullptr};
        Dataset dataset(static_cast<GDALDataset*>(
            GDALOpenEx(file_.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr,
                       nullptr)));
        if (!dataset)
            throw bad_request("{}: GDAL cannot read it as {}{}{}", file_, driver.what,
                              errors_.message().empty() ? "" : ": ", errors_.message());
        return dataset;
    }

    void add(const OGRFeature& feature, std::size_t number, std::vector<Area>& areas) {
        Area area{number, attributes_of(feature), {}};
        const OGRGeometry* geometry = feature.GetGeometryRef();
        if (geometry && geometry->getDimension() != 2) return;
        if (geometry) {
            const std::unique_ptr<OGRGeometry> straight(geometry->getLinearGeometry());
            add_rings(*straight, area);
        }
        areas.push_back(std::move(area));
    }

    static std::map<std::string, std::string> attributes_of(const OGRFeature& feature) {
        std::map<std::string, std::string> attributes;
        for (int i = 0; i < feature.GetFieldCount(); ++i) {
            if (!feature.IsFieldSetAndNotNull(i)) continue;
            std::string name = feature.GetFieldDefnRef(i)->GetNameRef();
            std::ranges::transform(name, name.begin(),
                                   [](unsigned char c) { return char(std::tolower(c)); });
            const char* value = const_cast<OGRFeature&>(feature).GetFieldAsString(i);
            if (*value != '\0') attributes.emplace(std::move(name), value);
        }
        // Where a GeoJSON feature has no properties, GDAL takes its members for them.
        const auto type = attributes.find("type");
        if (type != attributes.end() && type->second == "Feature") attributes.clear();
        return attributes;
    }

    void add_rings(const OGRGeometry& geometry, Area& area) {
        const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
        if (type == wkbPolygon) {
            for (const OGRLinearRing* ring : *geometry.toPolygon()) {
                corners_ += static_cast<std::size_t>(ring->getNumPoints());
                if (corners_ > most_corners_)
                    throw bad_request("{}: it has more than {} corners", file_,
                                      most_corners_);
                auto& points = area.rings.emplace_back();
                for (int i = 0; i < ring->getNumPoints(); ++i)
                    points.push_back({ring->getX(i), ring->getY(i)});
            }
        } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
            for (const OGRGeometry* part : *geometry.toGeometryCollection())
                add_rings(*part, area);
        }
    }

    const std::string file_;
    const std::size_t most_corners_;
    std::size_t corners_ = 0;
    QuietGdal quiet_;
    FirstError errors_;
};

}  // namespace

std::vector<Area> read_areas(const std::filesystem::path& file, VectorFormat format,
                             std::size_t most_corners) {
    return Reader(file, most_corners).areas(format);
}

}  // namespace cydonia
