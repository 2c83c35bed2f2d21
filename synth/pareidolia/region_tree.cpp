// Rusnell 2009, section 5.3.2, after Serra's homotopic trees [80].
#include "synth/pareidolia/region_tree.h"

#include <opencv2/imgproc.hpp>

namespace cydonia::pareidolia {
namespace {

// Labels of the cells of one colour, with a border of one cell; 0 elsewhere.
cv::Mat labels_of(const cv::Mat& cells, int connectivity) {
    cv::Mat labels;
    cv::connectedComponents(cells, labels, connectivity, CV_32S);
    return labels;
}

}  // namespace

RegionTree region_tree(const Field<std::uint8_t>& image) {
    const int width = image.width(), height = image.height();
    cv::Mat shadow = cv::Mat::zeros(height + 2, width + 2, CV_8U);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            shadow.at<std::uint8_t>(y + 1, x + 1) = image(x, y) ? 1 : 0;
    const cv::Mat dark = labels_of(shadow, 8), lit = labels_of(1 - shadow, 4);

    // OpenCV does not promise an order of its labels, so that regions are numbered in
    // reading order. To the left of a region's first cell is the region that surrounds
    // it.
    RegionTree tree;
    tree.regions.push_back({});
    std::vector<int> of_dark(static_cast<std::size_t>(width) * height + 2, -1);
    std::vector<int> of_lit = of_dark;
    of_lit[lit.at<int>(0, 0)] = RegionTree::kBackground;
    tree.region_at = Field<int>(width, height);
    for (int y = 0; y < height; ++y) {
        int left = RegionTree::kBackground;
        for (int x = 0; x < width; ++x) {
            const bool is_dark = image(x, y) != 0;
            int& region = is_dark ? of_dark[dark.at<int>(y + 1, x + 1)]
                                  : of_lit[lit.at<int>(y + 1, x + 1)];
            if (region < 0) {
                region = static_cast<int>(tree.regions.size());
                tree.regions.push_back({left, tree.regions[left].depth + 1});
            }
            tree.region_at(x, y) = left = region;
        }
    }
    return tree;
}

}  // namespace cydonia::pareidolia
