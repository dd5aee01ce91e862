#include "core/machine/checks/check.h"
#include "core/machine/timeline.h"
#include "core/pattern/catalogue.h"
#include "core/pattern/chart_edit.h"
#include "core/pattern/compile.h"
#include "core/pattern/swatch.h"

#include <gtest/gtest.h>

#include <set>

namespace knittsim::pattern {
namespace {

TEST(Catalogue, HasAtLeastThirtyDifferentModules) {
    std::set<std::string> ids;
    std::set<std::string> names;
    for (const Module& module : catalogue()) {
        ids.insert(module.id);
        names.insert(module.name);
        EXPECT_EQ(findModule(module.id), &module);
    }
    EXPECT_GE(ids.size(), 30U);
    EXPECT_EQ(ids.size(), catalogue().size());
    EXPECT_EQ(names.size(), catalogue().size());
}

/// A ground of plain with the module tiled over its middle, or stamped at the top.
Chart swatchOf(const Module& module) {
    Chart chart = plainChart(24, 30);
    if (module.tiles) {
        tile(chart, {4, 4, 16, 20}, module.part, PasteWhat::Stitches);
    } else {
        const bool left = module.part.at(0, 0).stitch == Stitch::Empty;
        paste(chart, {left ? 0 : chart.width - module.part.width, chart.height() - module.part.height()},
              module.part, PasteWhat::Stitches);
    }
    return chart;
}

TEST(Catalogue, EveryModuleKnitsWithoutErrors) {
    for (const Module& module : catalogue()) {
        const auto program = compile(swatchOf(module));
        ASSERT_TRUE(program) << module.id << ' ' << program.diagnostics().front().id;
        const machine::Timeline timeline(program.value(), machine::genericProfile());
        for (const Diagnostic& finding : machine::check(timeline)) {
            EXPECT_NE(finding.severity, Severity::Error)
                << module.id << ' ' << finding.id << " course " << finding.place.course;
        }
    }
}

} // namespace
} // namespace knittsim::pattern
