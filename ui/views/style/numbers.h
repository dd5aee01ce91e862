#pragma once

#include <QString>

namespace knittsim::ui {

/// Energy in uJ with a prefix that keeps it short: "12.3 mJ", "0".
QString energyText(double microJoule);

/// Three significant digits; very small and very large numbers with a power of ten: "3.2·10⁻⁴".
QString shortNumber(double value);

/// "10⁻³"
QString powerOfTen(int power);

/// A number as programs write it ("12.99", "1.5e-08"), with the decimal point of the locale.
QString withLocalPoint(QString number);

/// A whole number with the grouping of the locale.
QString countText(qint64 value);

} // namespace knittsim::ui
