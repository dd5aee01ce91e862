#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace knittsim::ui {

/// A line above one of two fabrics: what it is, how large it is, and room for buttons at the right.
class SideHeading : public QWidget {
    Q_OBJECT

public:
    explicit SideHeading(QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setSize(const QString& size); ///< in words, two lines
    QString title() const;
    QString sizeText() const;
    void addButton(QWidget* button);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void takePalette();

    QLabel* m_title;
    QLabel* m_size;
    QHBoxLayout* m_row;
};

} // namespace knittsim::ui
