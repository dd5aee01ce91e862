#pragma once

#include "ui/views/fabric_view/fabric_view.h"

#include <QFrame>

class QCheckBox;
class QLabel;
class QSlider;

namespace knittsim::ui {

/// How the photograph is laid over the fabric. Lies at the right of the view, hidden while there is none.
class PhotographCard : public QFrame {
    Q_OBJECT

public:
    explicit PhotographCard(FabricView& fabric);

signals:
    void openWanted();
    void alignWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    QSlider* slider(const QString& name, const QString& tip);
    void take();
    void apply();
    void place();

    FabricView& m_fabric;
    QLabel* m_title;
    QSlider* m_opacity;
    QSlider* m_wipe;
    QCheckBox* m_beside;
};

} // namespace knittsim::ui
