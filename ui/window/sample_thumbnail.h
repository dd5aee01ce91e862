#pragma once

#include "core/pattern/chart.h"

#include <QPainter>

namespace knittsim::ui {

/// A small drawing of a chart as it would look knitted: Vs for knit, bumps for purl, slanted strands for
/// moved loops. Shows as many whole cells as fit into `rect`, from the lower left corner of the chart.
void paintChartThumbnail(QPainter& painter, const QRectF& rect, const pattern::Chart& chart);

/// The same as a small PNG in base64, as project files have it.
QByteArray chartThumbnail(const pattern::Chart& chart);

/// The thumbnail of a project file; null where it has none.
QPixmap thumbnailOf(const QString& path);

} // namespace knittsim::ui
