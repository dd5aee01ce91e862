#pragma once

#include <array>
#include <string_view>

/// The needle lines of Kniterate k-code: a margin, the needles of one bed from left to right, a margin. Stops
/// of carrier and carriage are put in between as further characters.
namespace knittsim::formats::kcode {

constexpr int kMargin = 15;
constexpr int kNeedles = 252;
constexpr int kWrittenNeedles =
    kNeedles + 1; ///< in a stroke that works; the open knitout tool writes one more there
constexpr int kCarriers = 6;

constexpr char kMarginSign = '.';
constexpr char kWorks = '-';
constexpr char kRests = '_';
constexpr char kLeftStop = '/';
constexpr char kRightStop = '\\';

constexpr std::string_view kHome = "HOME";
constexpr std::string_view kComment = "//";
constexpr std::string_view kRightwards = ">>";
constexpr std::string_view kLeftwards = "<<";
constexpr std::string_view kRackPrefix = "RACK:";
constexpr std::string_view kFrontPrefix = "FRNT:";
constexpr std::string_view kFrontSizes = "STIF:";
constexpr std::string_view kRearPrefix = "REAR:";
constexpr std::string_view kRearSizes = "STIR:";

constexpr std::string_view kCarrierOut = "; carrier out"; ///< at the end of the comment before a pass

/// Where the carriers 1 to 6 stand when they are out, in needles from the first one.
constexpr std::array<double, kCarriers> kParking{-11.5, -9.5, -9.5, -7.5, -7.5, -7.5};

/// Stitch number of a sign 0 to 9, A to Z; -1 for others.
constexpr int numberOf(char sign) {
    return sign >= '0' && sign <= '9' ? sign - '0' : sign >= 'A' && sign <= 'Z' ? sign - 'A' + 10 : -1;
}

constexpr char signOf(int number) {
    return static_cast<char>(number < 10 ? '0' + number : 'A' + number - 10);
}

} // namespace knittsim::formats::kcode
