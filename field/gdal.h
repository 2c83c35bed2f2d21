#pragma once

#include <cpl_error.h>
#include <gdal.h>
#include <gdal_priv.h>

#include <memory>
#include <string>

#include "field/field.h"

namespace cydonia {

// Internal to field/. While this object exists, GDAL is ready for use and prints nothing;
// what it would have printed becomes part of our messages.
class QuietGdal {
  public:
    QuietGdal() {
        static const bool registered = (GDALAllRegister(), true);
        static_cast<void>(registered);
        CPLPushErrorHandler(CPLQuietErrorHandler);
        CPLErrorReset();
    }
    ~QuietGdal() { CPLPopErrorHandler(); }
    QuietGdal(const QuietGdal&) = delete;
    QuietGdal& operator=(const QuietGdal&) = delete;

    static std::string message() {
        const std::string text = CPLGetLastErrorMsg();
        return text.empty() ? "no reason given" : text;
    }
};

struct CloseDataset {
    void operator()(GDALDataset* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<GDALDataset, CloseDataset>;

// A dataset of one band in memory, for GDAL's algorithms.
Dataset memory_dataset(int width, int height, GDALDataType type);
void store(const Field<float>& values, GDALDataset& dataset);
void load(GDALDataset& dataset, Field<float>& values);

}  // namespace cydonia
