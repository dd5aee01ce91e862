#pragma once

#include "core/pattern/picture_chart.h"

#include <QDialog>
#include <QImage>

#include <atomic>
#include <memory>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QSpinBox;

namespace knittsim::document {
class Mailbox;
}

namespace knittsim::ui {

/// A picture becomes a chart: its size in stitches, their proportions, the colours. What it will look like is
/// shown all the time, worked out in the background.
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    /// `yarns`: of the chart that is open, to choose from; may be empty. `carriers`: of the machine.
    PictureDialog(const QString& path, std::vector<pattern::ChartYarn> yarns,
                  std::vector<std::string> carriers, QWidget* parent = nullptr);
    ~PictureDialog() override;

    pattern::Chart chart() const; ///< after it was accepted

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void readPicture(const QString& path);
    void takePicture(std::shared_ptr<const pattern::Picture> picture, const QString& problem);
    void keepProportions();
    void work();
    void takeCells(std::optional<pattern::PictureCells> cells);
    void showWords();
    void showPreview();
    double stitchAspect() const; ///< height of a stitch over its width
    bool usesOwnYarns() const;

    std::vector<pattern::ChartYarn> m_yarns;
    std::vector<std::string> m_carriers;
    std::shared_ptr<document::Mailbox> m_mailbox;
    std::shared_ptr<std::atomic<int>> m_round; ///< the newest work; older work ends
    std::shared_ptr<const pattern::Picture> m_picture;
    pattern::PictureOptions m_options;            ///< of m_cells, or of what is worked out
    std::optional<pattern::PictureCells> m_cells; ///< of what is chosen; nothing while it is worked out
    QImage m_preview;                             ///< a pixel for each stitch, of the last cells

    QLabel* m_view;
    QLabel* m_words;
    QProgressBar* m_progress;
    QSpinBox* m_wales;
    QSpinBox* m_courses;
    QCheckBox* m_keep;
    QDoubleSpinBox* m_walesPer10;
    QDoubleSpinBox* m_coursesPer10;
    QComboBox* m_source;
    QSpinBox* m_count;
    QCheckBox* m_dither;
    QComboBox* m_method;
    QPushButton* m_make;
};

} // namespace knittsim::ui
