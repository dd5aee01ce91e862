#include "knitted.h"

namespace knittsim::pattern {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string firstProblem(const Chart& chart) {
    const Diagnostics problems = check(chart);
    return problems.empty() ? "" : problems[0].id;
}

TEST(Chart, WellFormedChartHasNoProblem) {
    EXPECT_THAT(check(chartOf({"kpt", "mKr", "k.k"})), IsEmpty());
}

TEST(Chart, CellsMustFillTheCourses) {
    EXPECT_EQ(firstProblem(Chart()), "KS0501");
    Chart chart = chartOf({"kk"});
    chart.cells.pop_back();
    EXPECT_EQ(firstProblem(chart), "KS0501");
    EXPECT_EQ(firstProblem(Chart(kMaxWales + 1, 1)), "KS0501");
}

TEST(Chart, YarnsMustExist) {
    Chart chart = chartOf({"kk"});
    chart.at(1, 0).yarn = 2;
    EXPECT_EQ(firstProblem(chart), "KS0502");
    chart.at(1, 0).stitch = Stitch::Rest;
    EXPECT_EQ(firstProblem(chart), "") << "a resting wale takes no yarn";
}

TEST(Chart, MovesStayInsideAndTakeEveryLoopOnce) {
    for (const std::vector<LoopMove>& moves :
         {std::vector<LoopMove>{{0, 3}}, {{-1, 0}}, {{1, 1}}, {{0, 1}, {0, 2}}}) {
        Chart chart = chartOf({"kkk"});
        chart.course(0).moves = moves;
        EXPECT_EQ(firstProblem(chart), "KS0503");
    }
}

TEST(Chart, StitchesFitTheUseOfTheBeds) {
    EXPECT_EQ(firstProblem(chartOf({"kb"})), "KS0504");
    Chart chart = chartOf({"kk", "kk"});
    chart.course(1).rack = 1;
    EXPECT_EQ(firstProblem(chart), "KS0504");
    chart.beds = BedUse::Double;
    EXPECT_EQ(firstProblem(chart), "");
    chart.course(1).moves = {{0, 1}};
    EXPECT_EQ(firstProblem(chart), "KS0504");
}

TEST(Cross, ListsTheFrontGroupFirst) {
    EXPECT_THAT(cross(4, 2, 1, Front::Left), ElementsAre(LoopMove{4, 5}, LoopMove{5, 6}, LoopMove{6, 4}));
    EXPECT_THAT(cross(4, 2, 1, Front::Right), ElementsAre(LoopMove{6, 4}, LoopMove{4, 5}, LoopMove{5, 6}));
}

} // namespace
} // namespace knittsim::pattern
