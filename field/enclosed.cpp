#include "field/enclosed.h"

#include <opencv2/imgproc.hpp>

namespace cydonia {

Field<std::uint8_t> enclosed_by(const Field<std::uint8_t>& walls) {
    const int width = walls.width(), height = walls.height();
    cv::Mat open(height + 2, width + 2, CV_8U, cv::Scalar(1));  // one free cell all round
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (walls(x, y) != 0) open.at<std::uint8_t>(y + 1, x + 1) = 0;
    cv::Mat labels;  // 0 at walls
    cv::connectedComponents(open, labels, 4, CV_32S);
    const int outside = labels.at<int>(0, 0);
    Field<std::uint8_t> enclosed(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int label = labels.at<int>(y + 1, x + 1);
            enclosed(x, y) = label != 0 && label != outside ? 1 : 0;
        }
    return enclosed;
}

}  // namespace cydonia
