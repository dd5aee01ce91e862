#pragma once

#include "core/pattern/project.h"

#include <QDialog>

class QComboBox;
class QSpinBox;

namespace knittsim::ui {

/// Asks for the size and the ground of a new chart.
class NewChartDialog : public QDialog {
    Q_OBJECT

public:
    /// `machine`: id of the profile it is for; empty: generic.
    explicit NewChartDialog(QString machine, QWidget* parent = nullptr);

    pattern::Project project() const;

private:
    QString m_machine;
    QSpinBox* m_wales;
    QSpinBox* m_courses;
    QSpinBox* m_yarns;
    QComboBox* m_ground;
    QComboBox* m_beds;
};

} // namespace knittsim::ui
