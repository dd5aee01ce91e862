#pragma once

#include <QAbstractButton>
#include <QPixmap>

namespace knittsim::pattern {
struct Sample;
}

namespace knittsim::ui {

/// A sample as a button: drawing, title, one sentence.
class SampleCard : public QAbstractButton {
    Q_OBJECT

public:
    explicit SampleCard(const pattern::Sample& sample, QWidget* parent = nullptr);

    QString sampleId() const { return m_id; }

    static constexpr int kLeastWidth = 190;
    QSize sizeHint() const override { return {kLeastWidth, 198}; }
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString m_id;
    QString m_description;
    QPixmap m_picture; ///< drawn at the first painting
};

/// Title and description in the language of the window.
QString sampleTitle(const pattern::Sample& sample);
QString sampleDescription(const pattern::Sample& sample);

} // namespace knittsim::ui
