#pragma once

#include <QColor>
#include <QPainter>
#include <QStyledItemDelegate>

namespace knittsim::ui {

/// A short piece of twisted yarn.
void paintYarn(QPainter& painter, const QRectF& rect, const QColor& colour, int plies);

/// Two lines of text behind a piece of yarn; see YarnRole.
class YarnDelegate : public QStyledItemDelegate {
    Q_OBJECT

public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

} // namespace knittsim::ui
