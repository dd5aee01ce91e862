#pragma once

#include "ui/document/document.h"
#include "ui/views/pattern_editor/chart_look.h"

#include <QListWidget>

namespace knittsim::ui {

/// What the symbols and colours of the chart or grid at hand stand for; only those that it shows.
class LegendPanel : public QListWidget {
    Q_OBJECT

public:
    LegendPanel(document::Document& document, ChartLook& look, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {240, 260}; }

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void take();

    document::Document& m_document;
    ChartLook& m_look;
};

} // namespace knittsim::ui
