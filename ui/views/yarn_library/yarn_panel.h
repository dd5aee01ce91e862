#pragma once

#include "ui/document/document.h"
#include "ui/views/yarn_library/carrier_model.h"
#include "ui/views/yarn_library/yarn_model.h"

#include <QWidget>

class QComboBox;
class QLabel;
class QLineEdit;
class QListView;
class QMenu;
class QPushButton;
class QTextBrowser;

namespace knittsim::ui {

/// Carriers above, library below, details of the chosen yarn at the foot.
class YarnPanel : public QWidget {
    Q_OBJECT

public:
    explicit YarnPanel(document::Document& document, QWidget* parent = nullptr);

    /// Puts the cursor into the search field.
    void search();

private:
    void build();
    QLabel* makeHeading(const QString& text);
    QWidget* makeCarriers();
    QWidget* makeLibrary();
    void fitCarriers();
    void showDetails();
    void assign(const QModelIndex& yarn);
    void chooseColour(const QModelIndex& carrier);
    void changeEvent(QEvent* event) override;

    // yarn_panel_own.cpp: a person's own yarns
    QMenu* makeOwnMenu();
    void editYarn(const yarn::Yarn& yarn);
    QString askWhere(const QString& title, const QString& name);
    void importYarns();
    void exportYarn();
    void exportOwnYarns();
    std::vector<yarn::Yarn> ownYarns() const;
    void writeYarns(const QString& path, const std::string& json);
    void forgetYarn();
    void tellProblem(const QString& title, const Diagnostics& problems);
    void takeLibrary(const std::string& select);
    void takeFilter();

    document::Document& m_document;
    CarrierModel m_carriers;
    YarnModel m_yarns;
    QListView* m_carrierList = nullptr;
    QListView* m_yarnList = nullptr;
    QLineEdit* m_search = nullptr;
    QComboBox* m_filter = nullptr;
    QTextBrowser* m_details = nullptr;
    QPushButton* m_assign = nullptr;
    bool m_showsCarrier = false; ///< details of the carrier's yarn, else of the library's
};

} // namespace knittsim::ui
