#pragma once

#include "ui/document/document.h"

#include <QAbstractScrollArea>
#include <QHash>

namespace knittsim::ui {

/// The source of the open file, or of a file that could not be opened after showFailed(). Click or up and
/// down select the line's operation for all views.
class SourceView : public QAbstractScrollArea {
    Q_OBJECT

public:
    explicit SourceView(document::Document& document, QWidget* parent = nullptr);

    /// Shows a line of the open file; selects nothing.
    void showLine(int line);

    /// Shows a line of the file whose problems are listed: the failed one where there is one.
    void showProblemLine(int line);

    int currentLine() const { return m_line; }

    QSize sizeHint() const override { return {340, 420}; }
    QSize minimumSizeHint() const override { return {180, 140}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool event(QEvent* event) override;
    bool viewportEvent(QEvent* event) override;

private:
    void takeFile();
    void takeSelection();
    void layoutText();
    void showOpenFile();
    void goToLine(int line);
    void selectLine(int line);
    void paintLine(QPainter& painter, int number, const QRect& rect) const;
    void paintMargin(QPainter& painter, int number, const QRect& rect) const;
    int lineAt(int y) const;
    int lineHeight() const;
    int marginWidth() const;
    bool showsFailed() const { return m_failed; }

    document::Document& m_document;
    std::shared_ptr<const document::SourceText> m_text;
    QHash<int, int> m_problems; ///< worst Severity by line
    int m_line = -1;            ///< selected, 1-based
    int m_stepLine = -1;        ///< of the operation that was carried out last
    bool m_failed = false;      ///< shows the file that could not be opened
};

} // namespace knittsim::ui
