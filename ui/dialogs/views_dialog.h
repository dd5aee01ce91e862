#pragma once

#include "ui/document/named_views.h"

#include <QDialog>

class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace knittsim::ui {

/// Shows, renames and deletes the named views of a file.
class ViewsDialog : public QDialog {
    Q_OBJECT

public:
    explicit ViewsDialog(document::NamedViews& views, QWidget* parent = nullptr);

signals:
    void viewWanted(const QString& name);
    void viewsChanged();

private:
    void fill();
    void takeName(QListWidgetItem* item);
    void removeCurrent();
    void takeCurrent();

    document::NamedViews& m_views;
    QListWidget* m_list;
    QPushButton* m_show;
    QPushButton* m_rename;
    QPushButton* m_delete;
};

} // namespace knittsim::ui
