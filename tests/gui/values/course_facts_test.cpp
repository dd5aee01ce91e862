#include "ui/document/course_facts.h"

#include <gtest/gtest.h>

namespace knittsim::document {
namespace {

TEST(CourseFacts, TellCarriersInTheOrderOfTheirLastPass) {
    machine::Program program;
    program.header.carriers.resize(2);
    using machine::Direction;
    using machine::OperationKind;
    const auto knit = [&](Direction direction, int carrier) {
        machine::Operation operation;
        operation.kind = OperationKind::Knit;
        operation.direction = direction;
        operation.carriers.push(static_cast<machine::CarrierIndex>(carrier));
        program.operations.push_back(operation);
    };
    const auto set = [&](OperationKind kind, double value) {
        machine::Operation operation;
        operation.kind = kind;
        operation.value = value;
        program.operations.push_back(operation);
    };
    knit(Direction::Left, 0); // course 0
    knit(Direction::Right, 1);
    knit(Direction::Right, 0);
    set(OperationKind::StitchNumber, 4);
    set(OperationKind::Rack, -0.75);
    knit(Direction::Left, 1); // course 1
    const auto facts =
        courseFacts(program, 2, [](machine::OperationIndex operation) { return operation < 3 ? 0 : 1; });
    ASSERT_EQ(facts.size(), 2U);
    const std::vector<CourseFacts::Feed> first{{1, Direction::Right}, {0, Direction::Right}};
    EXPECT_EQ(facts[0].feeds, first);
    EXPECT_FALSE(facts[0].stitchSize);
    EXPECT_EQ(facts[1].stitchSize, 4.0);
    EXPECT_EQ(facts[1].racking, -0.75);
}

} // namespace
} // namespace knittsim::document
