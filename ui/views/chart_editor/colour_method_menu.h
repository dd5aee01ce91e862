#pragma once

#include "core/pattern/chart.h"

#include <QIcon>
#include <QMenu>

#include <functional>
#include <optional>

namespace knittsim::ui {

/// The ways to knit several colours, each with a picture of its courses from above: the rear bed over the
/// front bed.
class ColourMethodMenu : public QMenu {
    Q_OBJECT

public:
    /// `heading` says which courses are meant; `present`: the way they are knitted, if it is one.
    ColourMethodMenu(const QString& heading, std::optional<pattern::ColourMethod> present,
                     std::function<void(pattern::ColourMethod)> chosen, QWidget* parent);
};

QIcon colourMethodIcon(pattern::ColourMethod method, const QWidget& widget);

} // namespace knittsim::ui
