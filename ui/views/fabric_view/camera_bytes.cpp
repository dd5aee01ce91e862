#include "ui/views/fabric_view/camera_bytes.h"

#include <QDataStream>
#include <QIODevice>

namespace knittsim::ui {

namespace {

constexpr quint32 kMagic = 0x4b534331; // "KSC1"

void configure(QDataStream& stream) {
    stream.setVersion(QDataStream::Qt_6_0);
    stream.setFloatingPointPrecision(QDataStream::SinglePrecision);
}

} // namespace

QByteArray toBytes(const render::CameraState& state) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    configure(stream);
    stream << kMagic << state.target.x() << state.target.y() << state.target.z() << state.yaw << state.pitch
           << state.halfHeight << state.orthographic;
    return bytes;
}

std::optional<render::CameraState> cameraFromBytes(const QByteArray& bytes) {
    QDataStream stream(bytes);
    configure(stream);
    quint32 magic = 0;
    render::CameraState state;
    stream >> magic >> state.target.x() >> state.target.y() >> state.target.z() >> state.yaw >> state.pitch >>
        state.halfHeight >> state.orthographic;
    if (magic != kMagic || stream.status() != QDataStream::Ok) {
        return std::nullopt;
    }
    return state;
}

} // namespace knittsim::ui
