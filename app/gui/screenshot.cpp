#include "app/gui/screenshot.h"

#include <QCoreApplication>
#include <QPixmap>
#include <QTimer>

namespace knittsim::app {

namespace {

/// Curves and drawing follow the last frame within this time.
constexpr int kPaintMs = 700;

bool isDone(const document::Document& document) {
    using document::Activity;
    const Activity activity = document.activity();
    return !document.isOpening() && (activity == Activity::AtRest || activity == Activity::Failed ||
                                     activity == Activity::Paused || document.failedFile());
}

} // namespace

void takeScreenshot(ui::MainWindow& window, const QString& path, double seconds) {
    auto* shutter = new QTimer(&window);
    shutter->setSingleShot(true);
    QObject::connect(shutter, &QTimer::timeout, &window,
                     [&window, path] { QCoreApplication::exit(window.grab().save(path) ? 0 : 1); });
    const auto releaseWhenDone = [shutter, &window] {
        if (isDone(window.document())) {
            shutter->start(kPaintMs);
        }
    };
    QObject::connect(&window.document(), &document::Document::activityChanged, shutter, releaseWhenDone);
    shutter->start(static_cast<int>(seconds * 1000));
}

} // namespace knittsim::app
