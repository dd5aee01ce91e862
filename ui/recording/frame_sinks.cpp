#include "ui/recording/frame_sinks.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>
#include <QTemporaryDir>

namespace knittsim::ui {

namespace {

class PngSink : public FrameSink {
    Q_DECLARE_TR_FUNCTIONS(knittsim::ui::PngSink)

public:
    explicit PngSink(const QString& folder)
        : m_folder(folder), m_hidden(QFileInfo(folder).absolutePath() + QStringLiteral("/.knittsim-XXXXXX")) {
        if (QFileInfo::exists(folder)) {
            m_error = tr("%1 exists already; choose another name.").arg(folder);
        } else if (!m_hidden.isValid()) {
            m_error = m_hidden.errorString();
        }
    }

    bool add(const QImage& picture, const QString&, int) override {
        if (m_error.isEmpty()) {
            const QString name = QStringLiteral("%1.png").arg(++m_count, 5, 10, QLatin1Char('0'));
            if (!picture.save(m_hidden.filePath(name), "PNG")) {
                m_error = tr("A picture cannot be written to %1.").arg(m_folder);
            }
        }
        return m_error.isEmpty();
    }

    QString finish() override {
        constexpr auto kOpen = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner | QFile::ReadGroup |
                               QFile::ExeGroup | QFile::ReadOther | QFile::ExeOther;
        if (m_error.isEmpty() &&
            !(QFile::setPermissions(m_hidden.path(), kOpen) && QDir().rename(m_hidden.path(), m_folder))) {
            m_error = tr("The pictures cannot be written to %1.").arg(m_folder);
        }
        return m_error; // the hidden folder goes with this object, if it is still there
    }

private:
    QString m_folder;
    QTemporaryDir m_hidden;
    QString m_error;
    int m_count = 0;
};

class HandoutSink : public FrameSink {
    Q_DECLARE_TR_FUNCTIONS(knittsim::ui::HandoutSink)

public:
    HandoutSink(const QString& path, const QString& title) : m_path(path), m_title(title), m_file(path) {
        m_fine = m_file.open(QIODevice::WriteOnly);
        if (m_fine) {
            m_writer = std::make_unique<QPdfWriter>(&m_file);
            m_writer->setTitle(title);
            m_writer->setPageSize(QPageSize(QPageSize::A4));
            m_writer->setPageMargins(QMarginsF(18, 18, 18, 18), QPageLayout::Millimeter);
            m_writer->setResolution(300);
            m_fine = m_painter.begin(m_writer.get());
        }
    }

    bool add(const QImage& picture, const QString& words, int) override {
        if (!m_fine) {
            return false;
        }
        constexpr int kOnPage = 2;
        const int slot = m_count % kOnPage;
        if (m_count > 0 && slot == 0) {
            m_fine = m_writer->newPage();
        }
        ++m_count;
        const QRect page(QPoint(0, 0), QSize(m_writer->width(), m_writer->height()));
        const int titleHigh = page.height() / 24;
        QFont face = m_painter.font();
        if (slot == 0) {
            face.setPointSizeF(15);
            face.setBold(true);
            m_painter.setFont(face);
            m_painter.drawText(QRect(0, 0, page.width(), titleHigh), Qt::AlignLeft | Qt::AlignTop, m_title);
        }
        const int high = (page.height() - titleHigh) / kOnPage;
        const QRect box(0, titleHigh + slot * high, page.width(), high - titleHigh / 2);
        const QRect text(box.left(), box.bottom() - high / 5, box.width(), high / 5);
        QSize size = picture.size();
        size.scale(QSize(box.width(), box.height() - text.height() - 20), Qt::KeepAspectRatio);
        m_painter.drawImage(QRect(box.topLeft(), size), picture);
        face.setPointSizeF(12);
        face.setBold(false);
        m_painter.setFont(face);
        m_painter.drawText(text, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                           QStringLiteral("%1. %2").arg(m_count).arg(words));
        return m_fine;
    }

    QString finish() override {
        close();
        if (!m_fine || !m_file.commit()) {
            return tr("The hand-out cannot be written to %1.").arg(m_path);
        }
        return {};
    }

    ~HandoutSink() override { close(); }

private:
    void close() {
        if (m_painter.isActive()) {
            m_painter.end(); // before what it paints on goes
        }
        m_writer.reset();
    }

    QString m_path;
    QString m_title;
    QSaveFile m_file;
    std::unique_ptr<QPdfWriter> m_writer;
    QPainter m_painter;
    bool m_fine = false;
    int m_count = 0;
};

} // namespace

std::unique_ptr<FrameSink> makePngSink(const QString& folder) {
    return std::make_unique<PngSink>(folder);
}

std::unique_ptr<FrameSink> makeHandoutSink(const QString& path, const QString& title) {
    return std::make_unique<HandoutSink>(path, title);
}

} // namespace knittsim::ui
