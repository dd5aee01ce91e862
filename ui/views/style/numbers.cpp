#include "ui/views/style/numbers.h"

#include <QLocale>

#include <array>
#include <cmath>

namespace knittsim::ui {

namespace {

QString withMinus(QString text) {
    return text.replace(u'-', QChar(0x2212));
}

QString superscript(int value) {
    static const QString kDigits =
        QStringLiteral("\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079");
    QString text = value < 0 ? QStringLiteral("\u207b") : QString();
    for (const QChar digit : QString::number(std::abs(value))) {
        text += kDigits[digit.digitValue()];
    }
    return text;
}

/// Digits after the point that make three significant ones.
int decimals(double size) {
    return size >= 99.95 ? 0 : size >= 9.995 ? 1 : 2;
}

} // namespace

QString withLocalPoint(QString number) {
    return number.replace(u'.', QLocale().decimalPoint());
}

QString shortNumber(double value) {
    const double size = std::abs(value);
    if (!std::isfinite(value)) {
        return QStringLiteral("\u2013");
    }
    if (size == 0) {
        return QStringLiteral("0");
    }
    if (size >= 1e5 || size < 0.01) {
        const int power = static_cast<int>(std::floor(std::log10(size)));
        return withMinus(QLocale().toString(value / std::pow(10.0, power), 'f', 1)) +
               QStringLiteral("\u00b710") + superscript(power);
    }
    return withMinus(QLocale().toString(value, 'f', decimals(size)));
}

QString energyText(double microJoule) {
    struct Unit {
        double size;
        const char16_t* name;
    };
    constexpr std::array<Unit, 5> kUnits{
        {{1e6, u"J"}, {1e3, u"mJ"}, {1.0, u"\u00b5J"}, {1e-3, u"nJ"}, {1e-6, u"pJ"}}};
    const double size = std::abs(microJoule);
    if (!std::isfinite(microJoule) || size < 1e-9) {
        return QStringLiteral("0 \u00b5J");
    }
    for (const Unit& unit : kUnits) {
        if (size >= unit.size || &unit == &kUnits.back()) {
            return shortNumber(microJoule / unit.size) + QChar(0x202f) + QString::fromUtf16(unit.name);
        }
    }
    return {};
}

QString powerOfTen(int power) {
    return QStringLiteral("10") + superscript(power);
}

QString countText(qint64 value) {
    return QLocale().toString(value);
}

} // namespace knittsim::ui
