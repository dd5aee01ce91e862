#pragma once

#include <QFrame>

class QLabel;
class QPushButton;
class QToolButton;

namespace knittsim::ui {

/// A message in place, above the fabric. Hidden when empty.
class Banner : public QFrame {
    Q_OBJECT

public:
    enum class Kind { Note, Error };

    explicit Banner(QWidget* parent = nullptr);

    /// `action` names the button; empty hides it.
    void showMessage(Kind kind, const QString& text, const QString& action = {});
    QString text() const;

signals:
    void actionWanted();

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Kind m_kind = Kind::Note;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_action;
    QToolButton* m_close;
};

} // namespace knittsim::ui
