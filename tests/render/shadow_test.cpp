#include <gtest/gtest.h>

#include <cmath>

#include "field/error.h"
#include "render/shadow/caster.h"
#include "render/shadow/check.h"

namespace cydonia::render {
namespace {

using Mask = Field<std::uint8_t>;

Sun sun_at(double azimuth, double elevation) {
    return {radians(azimuth), radians(elevation)};
}

std::size_t area(const Mask& mask) {
    std::size_t n = 0;
    for (auto m : mask) n += m;
    return n;
}

// Heights of a function of metres east and north of the south-west corner.
template <class Function>
Field<float> land(int width, int height, double spacing, const Function& z) {
    Field<float> result(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            result(x, y) =
                static_cast<float>(z((x + 0.5) * spacing, (height - y - 0.5) * spacing));
    return result;
}

TEST(Caster, FlatLandHasNoShadow) {
    for (const float level : {0.0f, 1234.5f, -800.0f}) {
        const Caster caster(Field<float>(100, 60, level), 10.0);
        for (double elevation : {0.01, 1.0, 5.0, 45.0, 90.0})
            for (double azimuth = 0.0; azimuth < 360.0; azimuth += 22.5)
                EXPECT_EQ(area(caster.shadow(sun_at(azimuth, elevation), 2)), 0u)
                    << level << " m, " << azimuth << ", " << elevation;
    }
}

// A plane rising toward `uphill` at `slope`, under the sun at `azimuth`: all lit or all
// dark.
TEST(Caster, PlaneIsLitOrDarkAsAWhole) {
    int lit = 0, dark = 0;
    for (const int n : {16, 150})
        for (const double slope : {2.0, 10.0, 30.0, 60.0, 80.0})
            for (double uphill = 0.0; uphill < 360.0; uphill += 60.0) {
                const double rise = std::tan(radians(slope));
                const Vec3 up{rise * std::sin(radians(uphill)),
                              rise * std::cos(radians(uphill)), 0.0};
                const Caster caster(land(n, n, 10.0,
                                         [&](double east, double north) {
                                             return 500.0 + up.x * east + up.y * north;
                                         }),
                                    10.0);
                for (double elevation : {1.0, 3.0, 15.0, 45.0, 70.0})
                    for (double azimuth = 7.0; azimuth < 360.0; azimuth += 90.0) {
                        const Vec3 l = direction_to(sun_at(azimuth, elevation));
                        const double facing = dot(normalized({-up.x, -up.y, 1.0}), l);
                        if (std::abs(facing) < 0.002) continue;
                        const std::size_t all = 4u * n * n;
                        EXPECT_EQ(area(caster.shadow(sun_at(azimuth, elevation), 2)),
                                  facing > 0.0 ? 0u : all)
                            << slope << " up " << uphill << ", sun " << azimuth << " "
                            << elevation << " n " << n;
                        ++(facing > 0.0 ? lit : dark);
                    }
            }
    EXPECT_GT(lit, 200);
    EXPECT_GT(dark, 200);
}

}  // namespace
}  // namespace cydonia::render
