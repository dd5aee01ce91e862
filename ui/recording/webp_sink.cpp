#include "core/base/atomic_file.h"
#include "ui/recording/frame_sinks.h"

#include <QCoreApplication>

#include <webp/encode.h>
#include <webp/mux.h>

namespace knittsim::ui {

namespace {

class WebpSink : public FrameSink {
    Q_DECLARE_TR_FUNCTIONS(knittsim::ui::WebpSink)

public:
    explicit WebpSink(const QString& path) : m_path(path) {}
    ~WebpSink() override { WebPAnimEncoderDelete(m_encoder); }

    bool add(const QImage& picture, const QString&, int milliseconds) override {
        QImage image = picture.convertToFormat(QImage::Format_RGBA8888);
        if (!m_encoder) {
            begin(image.size());
        }
        if (image.size() != m_size) {
            image = image.scaled(m_size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        }
        WebPConfig config;
        WebPPicture frame;
        if (!m_encoder || !WebPConfigInit(&config) || !WebPPictureInit(&frame)) {
            return false;
        }
        config.lossless = 1;
        config.quality = 20; // effort
        config.method = 1;
        frame.use_argb = 1;
        frame.width = image.width();
        frame.height = image.height();
        m_fine = WebPPictureImportRGBA(&frame, image.constBits(), static_cast<int>(image.bytesPerLine())) &&
                 WebPAnimEncoderAdd(m_encoder, &frame, m_timeMs, &config);
        WebPPictureFree(&frame);
        m_timeMs += milliseconds;
        return m_fine;
    }

    QString finish() override {
        WebPData data;
        WebPDataInit(&data);
        const bool made = m_fine && WebPAnimEncoderAdd(m_encoder, nullptr, m_timeMs, nullptr) &&
                          WebPAnimEncoderAssemble(m_encoder, &data);
        bool written = false;
        if (made) {
            AtomicFile file(m_path.toStdString());
            file.write({reinterpret_cast<const char*>(data.bytes), data.size});
            written = static_cast<bool>(file.commit());
        }
        WebPDataClear(&data);
        return written ? QString()
               : made  ? tr("The animation cannot be written to %1.").arg(m_path)
                       : tr("The animation could not be made: its pictures are too large or there are none.");
    }

private:
    void begin(QSize size) {
        WebPAnimEncoderOptions options;
        if (WebPAnimEncoderOptionsInit(&options)) {
            m_encoder = WebPAnimEncoderNew(size.width(), size.height(), &options);
            m_size = size;
        }
    }

    QString m_path;
    QSize m_size;
    WebPAnimEncoder* m_encoder = nullptr;
    int m_timeMs = 0;
    bool m_fine = false;
};

} // namespace

std::unique_ptr<FrameSink> makeWebpSink(const QString& path) {
    return std::make_unique<WebpSink>(path);
}

} // namespace knittsim::ui
