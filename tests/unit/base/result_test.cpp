#include "core/base/result.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace knittsim {
namespace {

const Diagnostic kWarning{"KS0112", Severity::Warning, {}, {}};
const Diagnostic kError{"KS0001", Severity::Error, {}, {"gone"}};

TEST(Result, HoldsAValueAndItsWarnings) {
    Result<std::string> result(std::string("text"), {kWarning});
    EXPECT_TRUE(result);
    EXPECT_TRUE(result.hasValue());
    EXPECT_EQ(result.value(), "text");
    EXPECT_EQ(result->size(), 4u);
    EXPECT_EQ(result.diagnostics(), Diagnostics{kWarning});
}

TEST(Result, HoldsTheReasonWhyThereIsNoValue) {
    const Result<std::string> result = kError;
    EXPECT_FALSE(result);
    EXPECT_EQ(result.diagnostics(), Diagnostics{kError});
}

TEST(Result, KeepsAllFindingsOfAFailure) {
    const auto result = Result<int>::failure({kWarning, kError});
    EXPECT_FALSE(result);
    EXPECT_EQ(result.diagnostics().size(), 2u);
}

TEST(Result, GivesItsValueAway) {
    Result<std::unique_ptr<int>> result(std::make_unique<int>(7));
    const std::unique_ptr<int> taken = std::move(result).value();
    EXPECT_EQ(*taken, 7);
}

TEST(Diagnostics, CountOnlyErrorsAsErrors) {
    EXPECT_FALSE(hasErrors({}));
    EXPECT_FALSE(hasErrors({kWarning}));
    EXPECT_TRUE(hasErrors({kWarning, kError}));
}

} // namespace
} // namespace knittsim
