#pragma once

#include <string>

namespace cydonia::test {

// A little land of one distance stage; synthesis takes a moment.
inline const std::string kSmallScene = R"(title = "Small land"
seed = 7
[terrain]
extent = [1280.0, 1280.0]
samples = 64
[[terrain.stage]]
method = "distance"
[[terrain.stage.group]]
peaks = { count = 6 }
ridges = { count = 8 }
[[render.camera]]
name = "overhead"
kind = "overhead"
size = [96, 96]
)";

// A dark bar on light ground, to be shown by the sun from the south-west.
inline const std::string kBar =
    R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">
<rect width="64" height="64" fill="white"/>
<rect x="20" y="26" width="24" height="12" fill="black"/>
</svg>
)";

inline const std::string kShadowScene = R"(title = "A bar of shadow"
seed = 7
[terrain]
extent = [1280.0, 1280.0]
samples = 128
[[terrain.stage]]
method = "pareidolia"
solver = "features"
[[terrain.stage.image]]
target = "bar.svg"
sun = { azimuth = 215.0, elevation = 25.0 }
[[render.camera]]
name = "overhead"
kind = "overhead"
size = [192, 192]
)";

}  // namespace cydonia::test
