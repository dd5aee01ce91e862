#include "core/pattern/move_plan.h"

#include <gmock/gmock.h>

namespace knittsim::pattern {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<int> racksOf(const std::vector<LoopMove>& moves) {
    std::vector<int> racks;
    for (const MoveStep& step : planMoves(moves)) {
        racks.push_back(step.rack);
    }
    return racks;
}

std::vector<LoopMove> operator+(std::vector<LoopMove> a, const std::vector<LoopMove>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

TEST(PlanMoves, NothingToDo) {
    EXPECT_THAT(planMoves({}), IsEmpty());
}

TEST(PlanMoves, FrontGroupOfACableGoesFirst) {
    EXPECT_THAT(planMoves(cross(0, 2, 2, Front::Right)),
                ElementsAre(MoveStep{-2, {{2, 0}, {3, 1}}}, MoveStep{2, {{0, 2}, {1, 3}}}));
    EXPECT_THAT(planMoves(cross(0, 2, 2, Front::Left)),
                ElementsAre(MoveStep{2, {{0, 2}, {1, 3}}}, MoveStep{-2, {{2, 0}, {3, 1}}}));
}

TEST(PlanMoves, UnevenGroupsRackByTheSizeOfTheOther) {
    EXPECT_THAT(racksOf(cross(0, 3, 1, Front::Left)), ElementsAre(1, -3));
}

TEST(PlanMoves, EqualCablesShareTheirRackings) {
    EXPECT_THAT(racksOf(cross(0, 2, 2, Front::Right) + cross(8, 2, 2, Front::Right)), ElementsAre(-2, 2));
}

TEST(PlanMoves, OppositeCablesNeedOneRackingMore) {
    EXPECT_THAT(racksOf(cross(0, 2, 2, Front::Right) + cross(8, 2, 2, Front::Left)), ElementsAre(-2, 2, -2));
}

TEST(PlanMoves, LoopsStackedOnOneWaleKeepTheirOrder) {
    EXPECT_THAT(planMoves({{0, 1}, {2, 1}, {4, 5}}),
                ElementsAre(MoveStep{1, {{0, 1}, {4, 5}}}, MoveStep{-1, {{2, 1}}}));
    EXPECT_THAT(racksOf({{2, 1}, {0, 1}}), ElementsAre(-1, 1));
}

} // namespace
} // namespace knittsim::pattern
