#pragma once

#include "ui/document/document.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QToolButton;

namespace knittsim::ui {

class EnergyPlot;

/// Controls and course of the simulation.
class SimulationPanel : public QWidget {
    Q_OBJECT

public:
    explicit SimulationPanel(document::Document& document, QWidget* parent = nullptr);

    /// Starts or pauses, whichever applies.
    void toggleRunning();

private:
    void build();
    QToolButton* addButton(const char* name, const char* iconName, const QString& text, const QString& keys);
    void takeActivity();
    void takeFrame();
    void takeIntegrator();
    void takeLadders();
    void takeYarnRun();
    bool running() const { return m_document.activity() == document::Activity::Settling; }
    void changeEvent(QEvent* event) override;

    document::Document& m_document;
    QLabel* m_dot = nullptr;
    QLabel* m_state = nullptr;
    QToolButton* m_run = nullptr;
    QToolButton* m_step = nullptr;
    QToolButton* m_restart = nullptr;
    QToolButton* m_stop = nullptr;
    QComboBox* m_integrator = nullptr;
    QToolButton* m_yarn = nullptr;
    QComboBox* m_surroundings = nullptr;
    QLabel* m_yarnState = nullptr;
    QToolButton* m_ladders = nullptr;
    QCheckBox* m_holder = nullptr;
    QLabel* m_numbers = nullptr;
    EnergyPlot* m_plot = nullptr;
};

/// English names of the integrators in the language of the window.
QString integratorName(const simulation::IntegratorInfo& info);
QString integratorPurpose(const simulation::IntegratorInfo& info);

} // namespace knittsim::ui
