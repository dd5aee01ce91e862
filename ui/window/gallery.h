#pragma once

#include <QScrollArea>

#include <vector>

class QGridLayout;
class QVBoxLayout;

namespace knittsim::ui {

class SampleCard;

/// What is shown while nothing is open: the samples as cards, the files used last, and how to begin.
class Gallery : public QScrollArea {
    Q_OBJECT

public:
    explicit Gallery(QWidget* parent = nullptr);

    void setRecentFiles(const QStringList& files);

signals:
    void sampleChosen(const QString& id);
    void fileChosen(const QString& path);
    void openWanted();
    void newWanted();     ///< a new chart
    void pictureWanted(); ///< a chart from a picture

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void build();
    void placeCards();

    QGridLayout* m_grid = nullptr;
    QVBoxLayout* m_recent = nullptr;
    QWidget* m_recentBox = nullptr;
    std::vector<SampleCard*> m_cards;
    int m_columns = 0;
};

} // namespace knittsim::ui
