#pragma once

#include <QFrame>

#include <functional>

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
    /// A question with up to two answers; each hides the banner first. The second may be empty.
    void ask(const QString& text, const QString& action, std::function<void()> run, const QString& other = {},
             std::function<void()> runOther = {});
    QString text() const;

signals:
    void actionWanted(); ///< of showMessage()

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void answer(const std::function<void()>& run);

    Kind m_kind = Kind::Note;
    std::function<void()> m_run;
    std::function<void()> m_runOther;
    QLabel* m_icon;
    QLabel* m_text;
    QPushButton* m_action;
    QPushButton* m_other;
    QToolButton* m_close;
};

} // namespace knittsim::ui
