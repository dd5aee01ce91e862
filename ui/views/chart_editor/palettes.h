#pragma once

#include "core/pattern/catalogue.h"
#include "ui/document/document.h"
#include "ui/views/pattern_editor/chart_look.h"

#include <QMenu>
#include <QWidget>

class QButtonGroup;
class QHBoxLayout;
class QLineEdit;
class QListWidget;

namespace knittsim::ui {

/// Of the yarn `index` of a new chart: those that stand beside each other are well told apart.
yarn::Colour freshColour(std::size_t index);

/// Stitches that a tool can leave behind. One is chosen, or none: then tools change yarns only.
class StitchPalette : public QWidget {
    Q_OBJECT

public:
    explicit StitchPalette(ChartLook& look, QWidget* parent = nullptr);

    void setTwoBeds(bool two);
    void choose(std::optional<pattern::Stitch> stitch);
    std::optional<pattern::Stitch> chosen() const;
    /// The next one, +1, or the one before, -1, of those that are offered.
    void step(int direction);

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void takeLook();

    ChartLook& m_look;
    QButtonGroup* m_buttons;
};

/// The yarns of the chart. One is chosen, or none: then tools change stitches only.
class YarnPalette : public QWidget {
    Q_OBJECT

public:
    explicit YarnPalette(document::Document& document, QWidget* parent = nullptr);

    void choose(std::optional<std::uint8_t> yarn);
    std::optional<std::uint8_t> chosen() const { return m_chosen; }
    void step(int direction);
    void addYarn(); ///< on the next carrier, where there is one

signals:
    void changed();

private:
    void take();

    document::Document& m_document;
    QHBoxLayout* m_row;
    std::optional<std::uint8_t> m_chosen;
};

/// The catalogue and the modules that the person saved as pictures; the latter can be renamed (F2) and
/// deleted (Ctrl+Del), also from their context menu.
class CataloguePopup : public QMenu {
    Q_OBJECT

public:
    explicit CataloguePopup(ChartLook& look, QWidget* parent = nullptr);

signals:
    /// The module stays where it is until the next one is chosen.
    void chosen(const knittsim::pattern::Module* module);
    void problemFound(const QString& text); ///< a file of the person's modules cannot be used

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill();
    void find(const QString& text);
    void addItem(const pattern::Module& module, const QString& kind);
    void addOwnActions();

    ChartLook& m_look;
    QLineEdit* m_search;
    QListWidget* m_list;
    std::vector<pattern::Module> m_own;
    pattern::Module m_chosen;
};

} // namespace knittsim::ui
