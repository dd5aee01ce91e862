#pragma once

#include "ui/document/document.h"
#include "ui/document/file_watch.h"
#include "ui/document/named_views.h"
#include "ui/document/session.h"
#include "ui/views/pattern_editor/chart_look.h"

#include <QMainWindow>

#include <functional>
#include <memory>

class QActionGroup;
class QMenu;
class QStackedWidget;
class QToolButton;

namespace knittsim::ui {

class Banner;
class ChartEditor;
class Comparison;
class DiagnosticsPanel;
class FabricView;
class Gallery;
class HistoryCard;
class LessonPanel;
class MachineChoice;
class NeedleBeds;
class ChartArea;
class PatternGrid;
class PhotographCard;
class SimulationPanel;
struct Photograph;
class SourceView;
class Speaker;
class StatusLine;
class StepPlayer;
class TeachingBoard;
class YarnPanel;
struct RecordedStep;

/// Arrangements of the panels for different work.
enum class Layout { Standard, Teaching, Checking };

/// One window with one document.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    explicit MainWindow(QWidget* parent = nullptr);
    /// Shows a document as it is: what another window has released.
    explicit MainWindow(std::unique_ptr<document::Document> document, QWidget* parent = nullptr);
    ~MainWindow() override;

    /// Gives the document away, to a window in another language; this one is of no use then.
    std::unique_ptr<document::Document> releaseDocument();

    document::Document& document() { return m_document; }

    void openFile(const QString& path);
    void openSample(const QString& id);
    void applyLayout(Layout layout);
    /// Copies a machine profile into the user's folder and works on it; says what is wrong otherwise.
    void addMachine(const QString& path);
    /// Begins a lesson: one that came along, by id, or a file of one's own; says what is wrong with it
    /// otherwise.
    void openLesson(const QString& idOrPath);
    /// Writes the report of the last file tried, in the background.
    void exportReport(const QString& path);

    /// Records the range that is marked, else the bookmarks: as animation (.webp), hand-out (.pdf) or a
    /// folder of PNG files.
    void record(const QString& path);

    static QString openFilter();

signals:
    void languageChosen(const QString& id); ///< see language.h; what is written must be written anew

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    // main_window.cpp
    void buildCentre();
    void showWorkspace();
    void showGallery();
    void setAppearance(document::Appearance appearance);

    // main_window_document.cpp: files and programs that come, and the problems in them
    void connectDocument();
    void takeFile();
    void takeDocument();
    void takeFailure();
    void startSoon();
    void takeProblems();
    void showPlace(const Diagnostic& problem);
    void showLine(int line);
    void chooseFile();

    // main_window_chart.cpp
    void buildChartMenu();
    ChartArea* shownChart() const;
    void buildLookMenus(QMenu* menu);
    void takeChart();
    void takeLifted();
    void choosePicture();
    void importPicture(const QString& path);
    void takeTitle();
    void newChart();
    bool saveChart();
    bool saveChartAs();
    bool saveChartTo(const QString& path);
    void exportMachineData();
    /// Of the panels, in the order of the menu.
    std::vector<QDockWidget*> docks() const;
    /// A file to read, whose folder is remembered; empty when there is none.
    QString askWhich(const QString& title, const QString& filter);
    QString askWhere(const QString& title, const QString& start, const QStringList& kinds);
    void exportChart();
    void takeForeignChange();
    void reload();
    void offerRecovery();
    void restore(const document::Recovery::Leftover& leftover,
                 const std::shared_ptr<const pattern::Project>& project);
    /// Asks what to do with unsaved changes first; the action happens unless the person stays.
    void whenLeft(const std::function<void()>& action);

    // main_window_actions.cpp
    QAction* addAction(QMenu* menu, const QString& name, const QString& text, const QKeySequence& keys,
                       const QString& iconName, const std::function<void()>& action);
    QAction* addChoice(QMenu* menu, QActionGroup* group, const QString& name, const QString& text,
                       const QKeySequence& keys, const QString& iconName,
                       const std::function<void()>& action);
    void buildActions();
    void buildToolBar();
    void takeRecentFiles();
    void takeActions();

    // main_window_menus.cpp
    void buildFileMenu();
    void buildEditMenu();
    void buildMachineMenu();
    void buildSimulateMenu();
    void buildWindowMenu();
    void buildHelpMenu();

    // main_window_view_menu.cpp
    void buildViewMenu();

    // main_window_fabric.cpp: what the fabric shows, what is written over it, and what of it leaves the
    // program
    void connectFabric();
    void takeFabric();
    void takeFrame();
    void takePins();
    void takeYarnRun();
    void takeDescription();
    void takeNotice();
    void buildOverlayMenu(QMenu* view);
    void markProblems();
    QString describeLoop(int loop) const;
    void exportShown();

    // main_window_detail.cpp
    void buildDetailMenu(QMenu* view);
    void takeDetail();

    // main_window_compare.cpp
    void buildCompareMenu(QMenu* view);
    void takeCompareActions();
    void compareWithFile();
    void compareWithYarn();

    // main_window_views.cpp
    void buildViewsMenu(QMenu* view);
    void takeViews();
    void recallViews();
    void recallLook();
    void saveView();
    void recallView(const QString& name);
    void manageViews();

    // main_window_photograph.cpp
    void buildPhotographMenu(QMenu* view);
    void takePhotographActions();
    void choosePhotograph();
    void openPhotograph(Photograph wanted);
    void alignPhotograph();
    void recallPhotograph();
    void rememberPhotograph();
    void movePhotograph();

    // main_window_docks.cpp
    void buildDocks();
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* content,
                         Qt::DockWidgetArea area);
    void arrange(Layout layout);
    void takeClass();
    void takeTitleBars();
    void restoreSession();
    void saveSession();

    // main_window_teaching.cpp
    void buildTeaching();
    void buildLessonMenu();
    void buildLanguageMenu(QMenu* view);
    void listLessons();
    void chooseLesson();
    void takeLesson();
    void showGlossary();

    // main_window_player.cpp: marks kept with the file, and the voice
    void buildPlayer();
    void buildSpeechAction(QMenu* menu);
    void keepMarks();
    void recallMarks();
    void moveMarks();

    // main_window_recording.cpp
    void buildRecordingMenu(QMenu* menu);
    void record(const QString& path, std::vector<RecordedStep> steps);
    std::vector<RecordedStep> stepsToRecord() const;
    void chooseRecording(const QString& title, const QString& filter, const QString& extension);

    // main_window_report.cpp
    void chooseMachineFile();
    void chooseReportFile();
    void restoreChecks();
    void saveChecks();

    std::unique_ptr<document::Document> m_ownDocument;
    document::Document& m_document;
    document::Session m_session;
    document::FileWatch& m_watch; ///< of the document, which owns it
    ChartLook m_look;
    document::NamedViews m_views{m_session}; ///< of the open file
    QWidget* m_workspace = nullptr;
    QStackedWidget* m_pages = nullptr;
    Gallery* m_gallery = nullptr;
    Banner* m_banner = nullptr;
    FabricView* m_fabric = nullptr;
    Comparison* m_comparison = nullptr; ///< has the fabric, and what lies beside it
    PhotographCard* m_photograph = nullptr;
    QString m_photographKey;  ///< what is remembered of it; empty for what is not in a file
    int m_photographTurn = 0; ///< counts the files that have come
    HistoryCard* m_history = nullptr;
    StepPlayer* m_player = nullptr;
    Speaker* m_speaker = nullptr;
    QString m_marksKey; ///< of what the player's marks are; empty for what is not in a file
    PatternGrid* m_grid = nullptr;
    ChartEditor* m_chart = nullptr;
    QStackedWidget* m_patterns = nullptr; ///< grid or chart
    SourceView* m_source = nullptr;
    NeedleBeds* m_beds = nullptr;
    TeachingBoard* m_board = nullptr;
    LessonPanel* m_lesson = nullptr;
    QMenu* m_lessonMenu = nullptr;
    YarnPanel* m_yarns = nullptr;
    SimulationPanel* m_simulation = nullptr;
    DiagnosticsPanel* m_problems = nullptr;
    StatusLine* m_status = nullptr;
    QDockWidget* m_gridDock = nullptr;
    QDockWidget* m_sourceDock = nullptr;
    QDockWidget* m_yarnDock = nullptr;
    QDockWidget* m_simulationDock = nullptr;
    QDockWidget* m_problemDock = nullptr;
    QDockWidget* m_bedDock = nullptr;
    QDockWidget* m_legendDock = nullptr;
    QDockWidget* m_stepsDock = nullptr; ///< of the undo stack
    QDockWidget* m_lessonDock = nullptr;
    QToolBar* m_toolBar = nullptr;
    QToolButton* m_problemButton = nullptr;
    MachineChoice* m_machine = nullptr;
    QMenu* m_recentMenu = nullptr;
    QMenu* m_viewsMenu = nullptr;
    std::size_t m_problemsShown = 0; ///< errors and warnings
    QString m_nothingRuns;           ///< what the banner last said about ladders
    QString m_liftedNote;            ///< what it last said about machine data that became a chart
    QByteArray m_arrangement;        ///< of the docks while a file is open; empty: m_layout as it comes
    Layout m_layout = Layout::Standard;
};

} // namespace knittsim::ui
