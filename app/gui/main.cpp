#include "app/gui/screenshot.h"
#include "ui/views/style/appearance.h"
#include "ui/views/style/language.h"
#include "ui/window/key_guard.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QImageReader>
#include <QSurfaceFormat>

#include <cstdio>
#include <memory>
#include <optional>
#include <vector>

namespace {

using namespace knittsim;

struct Options {
    QStringList files;
    QString sample;
    QString lesson;
    std::optional<QString> language;
    QString screenshot;
    double wait = 20;
    int step = -1;
    std::optional<ui::Layout> layout;
    std::optional<document::Appearance> appearance;
};

constexpr int kMostMegabytes = 1024; ///< of a picture in memory

std::optional<ui::Layout> layoutNamed(const QString& name) {
    return name == QLatin1String("designer")  ? std::optional(ui::Layout::Standard)
           : name == QLatin1String("teacher") ? std::optional(ui::Layout::Teaching)
           : name == QLatin1String("qa")      ? std::optional(ui::Layout::Checking)
                                              : std::nullopt;
}

std::optional<document::Appearance> appearanceNamed(const QString& name) {
    return name == QLatin1String("system")  ? std::optional(document::Appearance::System)
           : name == QLatin1String("light") ? std::optional(document::Appearance::Light)
           : name == QLatin1String("dark")  ? std::optional(document::Appearance::Dark)
                                            : std::nullopt;
}

/// Empty when the command line cannot be used; what is wrong has been said then.
std::optional<Options> parse(QApplication& application) {
    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate(
        "main", "Turns knitting-machine programs into fabrics that settle while you watch."));
    parser.addHelpOption();
    parser.addVersionOption();
    const QCommandLineOption sample("sample", "Opens one of the samples, for example cable-braid.", "ID");
    const QCommandLineOption lesson("lesson", "Begins a lesson, for example 5-cable, or one of your own.",
                                    "ID or FILE");
    const QCommandLineOption language("language", "Language for this run: en or de.", "ID");
    const QCommandLineOption step("step", "Shows the machine after this many operations.", "N");
    const QCommandLineOption layout("layout", "Arrangement of the panels: designer, teacher or qa.", "NAME");
    const QCommandLineOption look("appearance", "Colours for this run: system, light or dark.", "NAME");
    const QCommandLineOption reset("reset-settings", "Forgets all settings first.");
    const QCommandLineOption software("software-gl", "Draws without a graphics card.");
    const QCommandLineOption shot(
        "screenshot", "Saves a picture of the window when the fabric is at rest, and ends.", "FILE");
    const QCommandLineOption wait("screenshot-after", "Does so after this time at the latest (20).",
                                  "SECONDS");
    parser.addOptions({sample, lesson, language, step, layout, look, reset, software, shot, wait});
    parser.addPositionalArgument("files", "Machine programs to open.", "[FILE...]");
    parser.process(application);
    if (parser.isSet(reset)) {
        document::Session().clear();
    }
    Options options;
    options.files = parser.positionalArguments();
    options.sample = parser.value(sample);
    options.lesson = parser.value(lesson);
    if (parser.isSet(language)) {
        options.language = parser.value(language);
    }
    options.screenshot = parser.value(shot);
    bool understood = true;
    if (parser.isSet(wait)) {
        options.wait = parser.value(wait).toDouble(&understood);
    }
    if (understood && parser.isSet(step)) {
        options.step = parser.value(step).toInt(&understood);
    }
    options.layout = layoutNamed(parser.value(layout));
    options.appearance = appearanceNamed(parser.value(look));
    const bool spoken = !options.language || ui::languages().contains(*options.language);
    if (!understood || !spoken || (parser.isSet(layout) && !options.layout) ||
        (parser.isSet(look) && !options.appearance)) {
        std::fputs("knittsim: an option has a value it cannot have; see knittsim --help\n", stderr);
        return std::nullopt;
    }
    return options;
}

void setUpOpenGl(int argc, char** argv) {
    for (int i = 1; i < argc; ++i) {
        if (qstrcmp(argv[i], "--software-gl") == 0) {
            qputenv("LIBGL_ALWAYS_SOFTWARE", "1");
            QCoreApplication::setAttribute(Qt::AA_UseSoftwareOpenGL);
        }
    }
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
    QCoreApplication::setAttribute(Qt::AA_ShareOpenGLContexts);
}

using Windows = std::vector<std::unique_ptr<ui::MainWindow>>;

/// Windows in the language that was chosen take the place of those there are, with their documents.
void speak(Windows& windows, const QString& language) {
    ui::applyLanguage(*qApp, language);
    for (std::unique_ptr<ui::MainWindow>& window : windows) {
        const bool shown = window->isVisible();
        auto next = std::make_unique<ui::MainWindow>(window->releaseDocument());
        QObject::connect(
            next.get(), &ui::MainWindow::languageChosen, qApp,
            [&windows](const QString& id) { speak(windows, id); }, Qt::QueuedConnection);
        next->setVisible(shown);
        window = std::move(next);
    }
}

/// One window for each file; one with the gallery when there is none.
Windows openWindows(const Options& options) {
    Windows windows;
    const auto count = std::max<qsizetype>(1, options.files.size());
    for (qsizetype i = 0; i < count; ++i) {
        windows.push_back(std::make_unique<ui::MainWindow>());
        ui::MainWindow& window = *windows.back();
        if (options.layout) {
            window.applyLayout(*options.layout);
        }
        if (options.step >= 0) {
            QObject::connect(&window.document(), &document::Document::opened, &window,
                             [&window, step = options.step] { window.document().setStep(step); });
        }
        window.show();
        if (i < options.files.size()) {
            window.openFile(options.files[i]);
        } else if (!options.lesson.isEmpty()) {
            window.openLesson(options.lesson);
        } else if (!options.sample.isEmpty()) {
            window.openSample(options.sample);
        }
    }
    return windows;
}

} // namespace

int main(int argc, char** argv) {
    setUpOpenGl(argc, argv);
    QApplication application(argc, argv);
    QCoreApplication::setApplicationName(QStringLiteral("KnittSim"));
    QCoreApplication::setApplicationVersion(QStringLiteral(KNITTSIM_VERSION));
    QGuiApplication::setDesktopFileName(QStringLiteral("io.github.knittsim.KnittSim"));
    ui::applyLanguage(application, document::Session().language());
    const std::optional<Options> options = parse(application);
    if (!options) {
        return 2;
    }
    if (options->language) {
        ui::applyLanguage(application, *options->language);
    }
    ui::applyAppearance(application, options->appearance.value_or(document::Session().appearance()));
    QImageReader::setAllocationLimit(kMostMegabytes);
    ui::KeyGuard guard;
    application.installEventFilter(&guard);
    Windows windows = openWindows(*options);
    for (const auto& window : windows) {
        QObject::connect(
            window.get(), &ui::MainWindow::languageChosen, qApp,
            [&windows](const QString& id) { speak(windows, id); }, Qt::QueuedConnection);
    }
    if (!options->screenshot.isEmpty()) {
        app::takeScreenshot(*windows.front(), options->screenshot, options->wait);
    }
    return QApplication::exec();
}
