#pragma once

#include "core/fabric/history.h"
#include "core/machine/timeline.h"
#include "core/pattern/chart_edit.h"
#include "ui/document/ladder.h"
#include "ui/document/opener.h"
#include "ui/document/prefix_builder.h"
#include "ui/document/problem_marks.h"
#include "ui/document/recovery.h"
#include "ui/document/selection.h"
#include "ui/document/simulation_bridge.h"
#include "ui/document/yarn_run.h"

#include <QObject>
#include <QUndoStack>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace knittsim::document {

/// What happens with the document now.
enum class Activity {
    Empty,   ///< nothing is open
    Opening, ///< the first file is being opened
    Machine, ///< as the machine leaves it; nothing moves yet
    Settling,
    Paused,
    AtRest, ///< see Document::stopReason()
    Failed, ///< the simulation gave up; the last good shape is kept
};

/// The open document: one file, its machine, its fabric, the yarns on the carriers, the operation that is
/// shown, the selection, and the running simulation. All functions: window thread; none waits for reading,
/// emulation or physics.
class Document : public QObject {
    Q_OBJECT

public:
    explicit Document(QObject* parent = nullptr);
    ~Document() override;

    /// The yarns that come with the program and the person's own, which go before those of the same id.
    const yarn::YarnLibrary& library() const { return *m_library; }
    std::shared_ptr<const yarn::YarnLibrary> sharedLibrary() const { return m_library; }
    /// Reads it again: own yarns have changed. Yarns on carriers stay as they are.
    void reloadLibrary();
    static QString ownYarnFolder(); ///< beside the settings; may not exist yet

    /// Opens in the background. While it works, and when it fails, the present file stays as it is. The
    /// simulation waits for start().
    void open(const QString& path);
    void openText(const QString& title, const QString& knitout);
    /// A chart that is not in a file yet.
    /// `modified`: it has changes that are nowhere saved.
    void openProject(const QString& title, std::shared_ptr<const pattern::Project> project,
                     bool modified = false);
    /// The chart of the machine data that is open, made in the background; undoable. Nothing where there is a
    /// chart already.
    void editAsChart();
    void cancelOpening();
    bool isOpening() const { return m_opener.busy(); }
    QString openingTitle() const { return m_openingTitle; }

    /// The open file, or null.
    std::shared_ptr<const OpenedFile> file() const { return m_file; }
    /// The last file that could not be read, or null when the last opening went well.
    std::shared_ptr<const OpenedFile> failedFile() const { return m_failed; }
    /// Problems of the last file tried that count.
    const Diagnostics& problems() const { return m_checked.findings; }
    /// Those that do not: rules turned off by the machine profile or by the person, with the reason.
    const std::vector<machine::Waived>& waived() const { return m_checked.waived; }

    /// Stitches of file() with a problem that counts; empty where a file could not be read.
    const ProblemMarks& problemMarks() const { return m_marks; }

    /// Rules that the person turned off, for every file.
    const std::vector<machine::Waiver>& rulesOff() const { return m_rulesOff; }
    void setRulesOff(std::vector<machine::Waiver> rules);
    void turnRuleOff(const std::string& rule, const std::string& reason);
    void turnRuleOn(const std::string& rule);

    /// Id of the machine profile that was chosen; empty: each file's own.
    QString chosenMachine() const { return m_machine; }
    /// Opens the present file on another machine, in the background; the yarns stay.
    void setMachine(const QString& id);

    /// What the designer works on; null where there is machine data only.
    std::shared_ptr<const pattern::Project> project() const { return m_project; }
    /// Changes the chart, undoable in one step; program and fabric follow in the background, and the newest
    /// chart wins. Where it cannot be knitted problems() says why and the fabric stays as it was.
    void editChart(const QString& text, const std::function<void(pattern::Chart&)>& edit);
    /// Changes the colourways, and with them the yarns of the chart; undoable in one step. Nothing is
    /// knitted anew.
    void editColourways(const QString& text,
                        const std::function<void(pattern::Colourways&, pattern::Chart&)>& edit);
    /// Program and fabric are those of the chart, which can be knitted.
    bool fabricFollowsChart() const;
    bool isRebuilding() const { return m_rebuilder.busy(); }
    /// Yarn was shown before the chart changed, and that of the present chart is not there yet.
    bool awaitsYarn() const { return m_yarnFollows || (m_yarnRun.running() && !showsYarn()); }
    /// The last loop of a cell; -1 where there is none, or while the fabric does not follow.
    LoopIndex loopOfCell(pattern::CellPlace place) const;
    std::optional<pattern::CellPlace> cellOfLoop(LoopIndex loop) const;
    /// Courses of the chart that are done at step().
    int knittedCourses() const;
    /// Of a chart; changes that are not saved.
    bool isModified() const { return m_project != nullptr && !m_undo.isClean(); }
    QString title() const { return m_title; } ///< of the open file
    QString path() const { return m_path; }   ///< empty for what is not in a file
    void keepCopy() { m_recovery.write(); }   ///< of unsaved changes, at once
    /// Writes the project; the undo stack is clean then. Errors: KS0002.
    Diagnostics save(const QString& path, const pattern::ProjectLook& look = {});
    /// Places of the chart's whole fabric in the bonding-point model, for ProjectLook; empty unless it is at
    /// rest.
    std::vector<float> shapeAtRest() const;

    /// Operations carried out in what is shown; 0 .. operationCount().
    OperationIndex step() const { return m_step; }
    OperationIndex operationCount() const { return m_file ? m_file->timeline->operationCount() : 0; }
    void setStep(OperationIndex count);
    void moveStep(int operations) { setStep(m_step + operations); }
    void movePass(int direction);
    void moveCourse(int direction);
    /// The machine after step(); about a millisecond.
    machine::MachineState machineState() const;

    /// The fabric after step() operations, as soon as it is built; null when nothing is open.
    std::shared_ptr<const fabric::Fabric> shownFabric() const;
    /// Operations that made shownFabric(); it follows step() as soon as the fabric is built.
    OperationIndex shownStep() const { return showsPrefix() ? m_prefix->count : operationCount(); }
    /// The latest shape of shownFabric(); null while there is none.
    std::shared_ptr<const simulation::Frame> shownFrame() const;

    /// The needles from which loops hang in shownFrame(); empty when the whole fabric is shown.
    const std::vector<fabric::NeedleHook>& needleHooks() const { return m_hooks; }

    /// Loops left on needles hang on a stitch holder (default); else they run as well.
    bool stitchHolder() const { return m_stitchHolder; }
    void setStitchHolder(bool on); ///< not while a ladder runs
    /// Loops of the whole fabric that nothing holds and that are still there.
    std::size_t unstableLoops() const;
    /// Loops that have run and were taken out.
    std::size_t removedLoops() const;
    bool laddersRun() const { return m_ladders.running(); }
    /// Shows the end of the program and takes the unstable loops out of the whole fabric, course by course;
    /// physics goes on from the present shape. Undoable in one step. While they run: takes all out at once.
    void removeLadders();
    void cancelLadders(); ///< while they run: undone, unless something else was done since

    const Selection& selection() const { return m_selection; }
    void selectLoop(LoopIndex loop);
    void selectPoint(fabric::PointIndex point); ///< of shownFabric(), with its loop; -1: nothing
    void selectOperation(OperationIndex operation);
    void selectLine(int line);
    void clearSelection();

    /// The bonding point that was selected, alone or with its loop; -1 where none is, and after stepping.
    fabric::PointIndex selectedPoint() const { return m_point; }
    /// What happened to it up to the operation shown; nothing without one. Replays a part of the program.
    std::optional<fabric::PointHistory> pointHistory() const;

    const std::vector<CarrierYarn>& carriers() const { return m_carriers; }
    /// Undoable. Keeps the shape and goes on from it; with the same body (machine::sameBody) physics is not
    /// touched.
    void assignYarn(int carrier, const yarn::Yarn& yarn);
    /// Undoable; only what is seen.
    void setCarrierColour(int carrier, yarn::Colour colour);
    QUndoStack* undoStack() { return &m_undo; }

    Activity activity() const;
    simulation::StopReason stopReason() const { return m_bridge.reason(); }
    /// The latest frame of the whole fabric, for energies and times; null before the first.
    std::shared_ptr<const simulation::Frame> frame() const { return m_bridge.frame(); }
    std::uint64_t generation() const { return m_bridge.generation(); }

    void start();
    void pause();
    void stepSimulation();
    void stop();
    QString integrator() const { return m_integrator; }
    void setIntegrator(const QString& id);
    /// Back to where the machine leaves the fabric, in the model that is shown; ladders that were taken out
    /// stay out.
    void restart();

    /// The whole fabric as real yarn (the yarn model), in the background; the shape is gone as soon as
    /// another fabric is shown or the simulation goes on.
    const YarnRun& yarnRun() const { return m_yarnRun; }
    /// Shows the end of the program, pauses the simulation and settles the yarn; while it runs: stops it at
    /// the present shape; stopped: goes on from there.
    void settleYarn();
    /// What the yarn lies on or hangs from, in this run and the next ones.
    void setSurroundings(simulation::Surroundings surroundings) { m_yarnRun.setSurroundings(surroundings); }
    bool showsYarn() const; ///< the shape of yarnRun() is that of shownFabric()

    /// Pulls the yarn at a bonding point of shownFabric() towards a place, mm; until releaseDrag().
    void drag(fabric::PointIndex point, Vec3 place);
    void releaseDrag();

    /// Bonding points of shownFabric() that are held where they are; none after another fabric is shown.
    const std::vector<fabric::PointIndex>& pins() const { return m_pins; }
    /// Holds the selected bonding point, or frees it.
    void togglePin();
    void removePins();

signals:
    void openingStarted();
    void openingStage(knittsim::document::OpeningStage stage);
    void openingEnded();  ///< well, badly or cancelled
    void fileChanged();   ///< file() changed: another one, or the program of a chart that was edited
    void opened();        ///< another file is shown now, told after fileChanged() and chartChanged()
    void chartChanged();  ///< project()
    void chartFollowed(); ///< fabricFollowsChart() or isRebuilding()
    void saved();
    void openFailed();
    void lifted();          ///< editAsChart() has come out well; file() has the notes
    void problemsChanged(); ///< problems(), waived() or rulesOff()
    void machineChanged();
    void stepChanged();
    void fabricShown(); ///< shownFabric() changed
    void frameShown();  ///< shownFrame() changed
    void selectionChanged();
    void pointChanged(); ///< selectedPoint() or its history
    void yarnsChanged();
    void libraryChanged();
    void activityChanged();
    void integratorChanged();
    void generationChanged(); ///< load or restart: histories begin anew
    void ladderChanged();     ///< stitchHolder(), unstableLoops(), removedLoops() or laddersRun() changed
    void yarnRunChanged();
    void pinsChanged();
    void nothingRuns(); ///< the answer to removeLadders() when there is nothing to remove

private:
    friend class YarnCommand;
    friend class LadderCommand;
    friend class ChartCommand;
    friend class ColourwayCommand;
    friend class LiftCommand;

    void begin(OpenRequest request);
    void take(const std::shared_ptr<const OpenedFile>& file);
    void show(const std::shared_ptr<const OpenedFile>& file);
    void exchangeFile(const std::shared_ptr<const OpenedFile>& file);
    void tellFile(bool another);
    void applyRulesOff();
    void select(const Selection& selection);
    void selectMoved();
    void setPoint(fabric::PointIndex point);
    fabric::PointIndex firstPointOf(LoopIndex loop) const;
    void applyYarn(int carrier, const yarn::Yarn& yarn);
    bool showsPrefix() const { return m_prefix != nullptr; }
    void updateShownFrame();

    // document_chart.cpp
    void putYarn(const std::string& carrier, const yarn::Yarn& yarn);
    void replaceYarns(std::shared_ptr<const pattern::Project> changed);
    void applyColourways(const pattern::Colourways& colourways, const std::vector<pattern::ChartYarn>& yarns);
    void applyPatch(const pattern::ChartPatch& patch, bool forwards);
    /// `whole`: the fabric of `file`, or that after its ladders have run.
    void exchangeProgram(const std::shared_ptr<const OpenedFile>& file,
                         const std::vector<CarrierYarn>& carriers,
                         const std::shared_ptr<const fabric::Fabric>& whole);
    void rebuild();
    void takeRebuilt(const std::shared_ptr<const OpenedFile>& file);
    void update(const std::shared_ptr<const OpenedFile>& file);
    void followWithYarn();

    // document_ladder.cpp
    void countLoops();
    void takeOut(const std::shared_ptr<Ladder>& ladder);
    void putBack(const Ladder& ladder);
    void takeLadderStep(const std::shared_ptr<const fabric::ReducedFabric>& reduced,
                        const std::vector<fabric::EntryIndex>& pairs);
    std::vector<float> presentPlaces() const;
    std::vector<float> placesOf(const std::vector<fabric::EntryIndex>& entries) const;
    void showWhole(std::shared_ptr<const fabric::Fabric> fabric, std::vector<float> places);

    // document_simulation.cpp
    void startYarn();
    void pin(fabric::PointIndex point, bool pinned);
    void forgetPins();
    /// -1 where the whole fabric has none, or not yet.
    fabric::EntryIndex wholeEntryOf(fabric::PointIndex point) const;

    std::shared_ptr<const yarn::YarnLibrary> m_library;
    Opener m_opener;
    Opener m_rebuilder; ///< of a chart that was edited
    std::shared_ptr<const pattern::Project> m_project;
    std::shared_ptr<const pattern::Project> m_knitted; ///< that the fabric is made of
    QString m_title;
    QString m_path;
    bool m_opensModified = false; ///< what is being opened
    QUndoStack m_undo;
    Recovery m_recovery{*this};
    QString m_openingTitle;
    std::shared_ptr<const OpenedFile> m_file;
    std::shared_ptr<const OpenedFile> m_failed;
    machine::CheckResult m_checked; ///< of m_failed, else of m_file
    ProblemMarks m_marks;
    std::vector<machine::Waiver> m_rulesOff;
    QString m_machine;
    std::shared_ptr<const fabric::Fabric> m_whole; ///< of the whole program; less what has run
    std::vector<CarrierYarn> m_carriers;
    OperationIndex m_step = 0;
    Selection m_selection;
    fabric::PointIndex m_point = -1; ///< of shownFabric()
    PrefixBuilder m_prefixes;
    std::shared_ptr<const PrefixFabric> m_prefix; ///< null when the whole fabric is shown
    std::shared_ptr<const simulation::Frame> m_prefixFrame;
    std::vector<fabric::NeedleHook> m_hooks; ///< of m_prefixFrame
    SimulationBridge m_bridge;
    QString m_integrator;
    YarnRun m_yarnRun;
    bool m_yarnFollows = false; ///< once the bonding points of an edited chart are at rest
    std::vector<fabric::PointIndex> m_pins;
    LadderRunner m_ladders;
    fabric::Runs m_runs; ///< of m_whole, or of the fabric before the ladder that runs
    std::size_t m_loopsGone = 0;
    bool m_stitchHolder = true;
    bool m_restartAfterLadder = false;
};

} // namespace knittsim::document
