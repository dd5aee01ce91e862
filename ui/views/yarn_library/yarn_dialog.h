#pragma once

#include "core/yarn/count.h"
#include "core/yarn/yarn.h"

#include <QDialog>

#include <map>

class QComboBox;
class QDialogButtonBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace knittsim::ui {

/// A yarn of one's own, number by number. What a yarn file would not be read with is refused here, too, with
/// the reason below its field.
class YarnDialog : public QDialog {
    Q_OBJECT

public:
    explicit YarnDialog(const yarn::Yarn& yarn, QWidget* parent = nullptr);

    /// As it is in the fields; the id is made from the name unless the yarn had one.
    yarn::Yarn yarn() const;

private:
    struct Field {
        QLineEdit* edit = nullptr;
        QLabel* reason = nullptr;
    };

    /// `key`: of the yarn file.
    QLineEdit* addField(QFormLayout* form, const QString& key, const QString& name, const QString& text,
                        const QString& help);
    void addRow(QFormLayout* form, const QString& key, const QString& name, QWidget* editor, QLineEdit* edit);
    QWidget* makeCount();
    QWidget* makeDiameters();
    void fill();
    void convertCount();
    void computeDiameters();
    void chooseColour();
    void check();
    double number(const QString& key) const; ///< not a number where it is none
    double tex() const;

    yarn::Yarn m_original;
    yarn::Colour m_colour;
    std::map<QString, Field> m_fields; ///< by key
    QComboBox* m_fibre;
    QComboBox* m_system;
    QLabel* m_counts;
    QLineEdit* m_packing;
    QComboBox* m_surface;
    QPushButton* m_colourButton;
    QDialogButtonBox* m_buttons;
    std::map<std::string, std::string> m_sources;
};

} // namespace knittsim::ui
