#include "ui/dialogs/picture_reading.h"

#include <QFile>
#include <QImageReader>
#include <QPainter>

#include <algorithm>

namespace knittsim::ui {

namespace {

/// Ends for its reader where it is told to.
class WatchedFile : public QFile {
public:
    WatchedFile(const QString& path, const std::function<bool(double)>& goesOn)
        : QFile(path), m_goesOn(goesOn) {}

    bool ended() const { return m_ended; }

protected:
    qint64 readData(char* data, qint64 size) override {
        const auto whole = static_cast<double>(std::max<qint64>(1, this->size()));
        m_ended = m_ended || !m_goesOn(static_cast<double>(pos()) / whole);
        return m_ended ? -1 : QFile::readData(data, size);
    }

private:
    const std::function<bool(double)>& m_goesOn;
    bool m_ended = false;
};

} // namespace

std::pair<std::shared_ptr<const pattern::Picture>, QString>
readPictureFile(const QString& path, const std::function<bool(double)>& goesOn) {
    WatchedFile file(path, goesOn);
    if (!file.open(QIODevice::ReadOnly)) {
        return {nullptr, file.errorString()};
    }
    QImageReader reader(&file);
    reader.setAutoTransform(true);
    const QImage read = reader.read();
    if (read.isNull() || file.ended()) {
        return {nullptr, reader.errorString()};
    }
    QImage image(read.size(), QImage::Format_RGB888);
    image.fill(Qt::white); // as paper
    QPainter(&image).drawImage(0, 0, read);
    auto picture = std::make_shared<pattern::Picture>();
    picture->width = image.width();
    picture->height = image.height();
    picture->rgb.reserve(std::size_t(image.width()) * std::size_t(image.height()) * 3);
    for (int y = 0; y < image.height(); ++y) {
        if (y % 64 == 0 && !goesOn(1)) {
            return {nullptr, {}};
        }
        const uchar* row = image.constScanLine(y);
        picture->rgb.insert(picture->rgb.end(), row, row + std::ptrdiff_t{image.width()} * 3);
    }
    return {picture, {}};
}

} // namespace knittsim::ui
