#include "ui/views/style/appearance.h"

#include <QApplication>
#include <QPainter>
#include <QStyle>
#include <QStyleFactory>
#include <QToolTip>
#include <QWidget>

namespace knittsim::ui {

namespace {

struct Tones {
    QColor window, base, alternate, text, faint, button, light, mid, dark, shadow, highlight, highlightedText,
        link, tip;
};

QPalette makePalette(const Tones& t) {
    QPalette p;
    p.setColor(QPalette::Window, t.window);
    p.setColor(QPalette::WindowText, t.text);
    p.setColor(QPalette::Base, t.base);
    p.setColor(QPalette::AlternateBase, t.alternate);
    p.setColor(QPalette::Text, t.text);
    p.setColor(QPalette::Button, t.button);
    p.setColor(QPalette::ButtonText, t.text);
    p.setColor(QPalette::BrightText, Qt::white);
    p.setColor(QPalette::Light, t.light);
    p.setColor(QPalette::Midlight, t.light);
    p.setColor(QPalette::Mid, t.mid);
    p.setColor(QPalette::Dark, t.dark);
    p.setColor(QPalette::Shadow, t.shadow);
    p.setColor(QPalette::Highlight, t.highlight);
    p.setColor(QPalette::HighlightedText, t.highlightedText);
    p.setColor(QPalette::Link, t.link);
    p.setColor(QPalette::LinkVisited, t.link);
    p.setColor(QPalette::ToolTipBase, t.tip);
    p.setColor(QPalette::ToolTipText, t.text);
    p.setColor(QPalette::PlaceholderText, t.faint);
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor disabled = t.text;
        disabled.setAlphaF(0.42F);
        p.setColor(QPalette::Disabled, role, disabled);
    }
    p.setColor(QPalette::Disabled, QPalette::Highlight, t.mid);
    p.setColor(QPalette::Disabled, QPalette::HighlightedText, t.text);
    return p;
}

// Properties of the application.
constexpr const char* kContrast = "highContrast";
constexpr const char* kAppearance = "appearance";

QPalette sharpened(QPalette palette) {
    const bool dark = isDark(palette);
    const QColor ground = dark ? Qt::black : Qt::white;
    const QColor ink = dark ? Qt::white : Qt::black;
    for (const QPalette::ColorRole role : {QPalette::Window, QPalette::Base, QPalette::AlternateBase}) {
        palette.setColor(role, ground);
    }
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText}) {
        palette.setColor(QPalette::Active, role, ink);
        palette.setColor(QPalette::Inactive, role, ink);
    }
    palette.setColor(QPalette::Highlight, dark ? QColor(0xffd500) : QColor(0x003f8c));
    palette.setColor(QPalette::HighlightedText, ground);
    return palette;
}

} // namespace

QPalette lightPalette() {
    return makePalette({.window = QColor(0xf3f4f6),
                        .base = QColor(0xffffff),
                        .alternate = QColor(0xf7f8fa),
                        .text = QColor(0x1d232b),
                        .faint = QColor(0x5c6674),
                        .button = QColor(0xf7f8fa),
                        .light = QColor(0xffffff),
                        .mid = QColor(0xcfd4db),
                        .dark = QColor(0xb3bac4),
                        .shadow = QColor(0x8b939f),
                        .highlight = QColor(0x1f6a99),
                        .highlightedText = QColor(0xffffff),
                        .link = QColor(0x1f6a99),
                        .tip = QColor(0xffffff)});
}

QPalette darkPalette() {
    return makePalette({.window = QColor(0x22262c),
                        .base = QColor(0x1a1d22),
                        .alternate = QColor(0x1f2329),
                        .text = QColor(0xe3e7ec),
                        .faint = QColor(0x9aa4b1),
                        .button = QColor(0x2b3038),
                        .light = QColor(0x3a414b),
                        .mid = QColor(0x3a414b),
                        .dark = QColor(0x14171b),
                        .shadow = QColor(0x0c0e11),
                        .highlight = QColor(0x2f83b7),
                        .highlightedText = QColor(0xffffff),
                        .link = QColor(0x6db5e0),
                        .tip = QColor(0x2f353e)});
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Window).lightness() < 128;
}

void applyAppearance(QApplication& application, document::Appearance appearance) {
    static const bool kSystemDark = isDark(application.palette());
    application.setProperty(kAppearance, static_cast<int>(appearance));
    const bool dark = appearance == document::Appearance::Dark ||
                      (appearance == document::Appearance::System && kSystemDark);
    if (application.style()->name() != QLatin1String("fusion")) {
        application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    }
    const QPalette plain = dark ? darkPalette() : lightPalette();
    const QPalette palette = application.property(kContrast).toBool() ? sharpened(plain) : plain;
    application.setPalette(palette);
    QToolTip::setPalette(palette);
}

void applyContrast(QApplication& application, bool on) {
    if (application.property(kContrast).toBool() != on) {
        application.setProperty(kContrast, on);
        applyAppearance(application,
                        static_cast<document::Appearance>(application.property(kAppearance).toInt()));
    }
}

Accents accentsOf(const QPalette& palette) {
    if (isDark(palette)) {
        return {QColor(0x6cc48d), QColor(0x6db5e0), QColor(0xe6b450),
                QColor(0xf07f73), QColor(0x9aa4b1), QColor(0x343a43)};
    }
    return {QColor(0x1f7a45), QColor(0x1f6a99), QColor(0x8a5a00),
            QColor(0xb3261e), QColor(0x5c6674), QColor(0xdde1e6)};
}

void paintCard(QWidget& card) {
    QPainter painter(&card);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(accentsOf(card.palette()).line);
    painter.setBrush(card.palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(QRectF(card.rect()).adjusted(0.5, 0.5, -0.5, -0.5), 8, 8);
}

QColor inkOn(const QColor& ground) {
    const double light = 0.2126 * ground.redF() + 0.7152 * ground.greenF() + 0.0722 * ground.blueF();
    return light > 0.45 ? QColor(0x14, 0x18, 0x1e) : QColor(0xff, 0xff, 0xff);
}

} // namespace knittsim::ui
