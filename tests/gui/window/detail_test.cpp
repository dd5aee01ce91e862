#include "tests/gui/window/window_fixture.h"
#include "ui/views/fabric_view/fabric_view.h"

#include <QAction>
#include <QLabel>

#include <optional>
#include <tuple>

namespace knittsim::ui {

using render::DetailLevel;

/// The level of detail that a person fixes, and what is told of it.
class DetailTest : public WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() { prepare(); }

    void init() { beginTest(); }

    void cleanup() { endTest(); }

    void aFixedLevelIsDrawnAndTold() {
        openSample("plain");
        QVERIFY(action("actionDetailAuto")->isChecked());
        for (const auto& [name, level, word] :
             {std::tuple("actionDetailYarn", DetailLevel::Yarn, "full yarn"),
              {"actionDetailTubes", DetailLevel::Tubes, "plain tubes"},
              {"actionDetailStrokes", DetailLevel::Strokes, "strokes"}}) {
            action(name)->trigger();
            QTRY_COMPARE_WITH_TIMEOUT(fabric()->detailDrawn(), std::optional(level), 30000);
            QCOMPARE(child<QLabel>("statusDetail")->text(), QString(word));
        }
        press(Qt::Key_3, Qt::AltModifier); // the mesh has no levels
        QTRY_COMPARE_WITH_TIMEOUT(fabric()->detailDrawn(), std::optional<DetailLevel>(), 30000);
        QVERIFY(child<QLabel>("statusDetail")->text().isEmpty());
    }

    void itIsRemembered() {
        action("actionDetailTubes")->trigger();
        openWindow();
        QVERIFY(action("actionDetailTubes")->isChecked());
        QCOMPARE(fabric()->detail(), std::optional(DetailLevel::Tubes));
        action("actionDetailAuto")->trigger();
        openWindow();
        QVERIFY(!fabric()->detail());
    }
};

} // namespace knittsim::ui

QTEST_MAIN(knittsim::ui::DetailTest)
#include "detail_test.moc"
