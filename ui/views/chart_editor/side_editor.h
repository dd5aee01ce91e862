#pragma once

#include <QLineEdit>

#include <functional>
#include <optional>

namespace knittsim::ui {

/// A field over a place beside the chart. Return and leaving it give the number to `taken` (nothing where it
/// is empty), Escape does not; then it goes. What is no number in the range stays in the field, with the
/// reason as its tooltip.
class SideEditor : public QLineEdit {
    Q_OBJECT

public:
    struct Range {
        double low = 0;
        double high = 0;
        bool whole = false; ///< numbers only
    };

    SideEditor(const QRect& place, const QString& text, Range range,
               std::function<void(std::optional<double>)> taken, QWidget* parent);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    void finish();

    Range m_range;
    std::function<void(std::optional<double>)> m_taken;
};

} // namespace knittsim::ui
