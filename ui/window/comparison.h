#pragma once

#include "ui/document/document.h"
#include "ui/views/fabric_view/fabric_view.h"

#include <QWidget>

#include <memory>
#include <optional>

class QSplitter;
class QToolButton;

namespace knittsim::ui {

class SideHeading;

/// The fabric of the document and, when asked, another one beside it in the same scale: a state that was
/// kept, another file, or the same program with another yarn. The second one has a document of its own, so
/// that it settles at the same time. The cameras are linked by default: each move of one moves the other, so
/// that the middles of the fabrics stay at the same place.
class Comparison : public QWidget {
    Q_OBJECT

public:
    /// Takes `fabric` in.
    Comparison(document::Document& document, FabricView& fabric, QWidget* parent = nullptr);
    ~Comparison() override;

    void keepState();                                   ///< as it is shown now; nothing where nothing is open
    void openFile(const QString& path);                 ///< the other side is empty until the file is read
    void openYarn(int carrier, const yarn::Yarn& yarn); ///< on this carrier; on all where it is -1
    void close();
    bool isOpen() const { return m_other != nullptr; }

    void setLinked(bool on); ///< a fresh link gives the other side this side's camera
    bool isLinked() const { return m_linked; }

    void fit(); ///< both, in one scale

    FabricView* other() const { return m_other; } ///< null while closed
    QString otherTitle() const;
    QString sizes(bool other) const; ///< as the headings tell them

signals:
    void changed();                   ///< isOpen() or isLinked()
    void failed(const QString& text); ///< a file that cannot be opened; the comparison is closed then

private:
    QWidget* column(SideHeading* heading, FabricView* view);
    QToolButton* button(const QString& name, const QString& iconName, const QString& tip);
    void openOther(const QString& title);
    void removeOther();
    document::Document& makeDocument();
    void takeOpened(int carrier, const std::optional<yarn::Yarn>& yarn);
    void takeOther();
    void follow(FabricView& from, FabricView& to);
    void takeHeadings();
    void makeRoom();

    document::Document& m_document;
    FabricView& m_fabric;
    QSplitter* m_splitter;
    SideHeading* m_heading;
    SideHeading* m_otherHeading = nullptr;
    QToolButton* m_link = nullptr;
    QToolButton* m_settle = nullptr;
    FabricView* m_other = nullptr;
    std::unique_ptr<document::Document> m_otherDocument; ///< null for a state that was kept
    std::shared_ptr<const fabric::Fabric> m_shownFabric; ///< of m_otherDocument
    QString m_otherTitle;
    bool m_linked = true;
    bool m_following = false;
};

} // namespace knittsim::ui
