#include "ui/dialogs/glossary_dialog.h"

#include "ui/views/needle_beds/needle_beds.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace knittsim::ui {

namespace {

constexpr double kOperationsPerSecond = 0.6;
constexpr int kOperationMs = 1700;
constexpr int kRestMs = 1500; ///< before it begins again

} // namespace

GlossaryDialog::GlossaryDialog(QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("glossaryDialog"));
    setWindowTitle(tr("Words of machine knitting"));
    m_list = new QListWidget(this);
    m_list->setObjectName(QStringLiteral("glossaryList"));
    m_list->setAccessibleName(tr("Words"));
    m_list->setToolTip(tr("Choose a word (up and down)"));
    m_list->setMaximumWidth(160);
    for (const GlossaryEntry& entry : m_entries) {
        m_list->addItem(entry.word);
    }
    m_word = new QLabel(this);
    m_word->setObjectName(QStringLiteral("glossaryWord"));
    QFont large = font();
    large.setPointSizeF(1.6 * large.pointSizeF());
    large.setBold(true);
    m_word->setFont(large);
    m_text = new QLabel(this);
    m_text->setObjectName(QStringLiteral("glossaryText"));
    m_text->setWordWrap(true);
    large.setPointSizeF(1.2 * font().pointSizeF());
    large.setBold(false);
    m_text->setFont(large);
    m_stage = new NeedleBeds(m_document, this);
    m_stage->setSpeed(kOperationsPerSecond);
    m_stage->setPlaying(true);
    auto* right = new QVBoxLayout;
    right->addWidget(m_word);
    right->addWidget(m_text);
    right->addWidget(m_stage, 1);
    auto* row = new QHBoxLayout(this);
    row->addWidget(m_list);
    row->addLayout(right, 1);
    resize(900, 460);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &GlossaryDialog::next);
    connect(m_list, &QListWidget::currentRowChanged, this, &GlossaryDialog::showRow);
    connect(&m_document, &document::Document::opened, this, [this] {
        m_document.setStep(m_entries[static_cast<std::size_t>(m_row)].from);
        m_stage->follow();
        m_timer.start(kOperationMs / 2);
    });
    m_list->setCurrentRow(0);
}

GlossaryDialog::~GlossaryDialog() {
    delete m_stage; // it looks at the document, which goes before the dialog's children would
}

void GlossaryDialog::showWord(const QString& id) {
    const auto found = std::ranges::find(m_entries, id, &GlossaryEntry::id);
    if (found != m_entries.end()) {
        m_list->setCurrentRow(static_cast<int>(found - m_entries.begin()));
    }
}

QString GlossaryDialog::shownWord() const {
    return m_row < 0 ? QString() : m_entries[static_cast<std::size_t>(m_row)].id;
}

void GlossaryDialog::showRow(int row) {
    if (row < 0) {
        return;
    }
    m_row = row;
    m_timer.stop();
    const GlossaryEntry& entry = m_entries[static_cast<std::size_t>(row)];
    m_word->setText(entry.word);
    m_text->setText(entry.text);
    m_document.openText(entry.word, entry.knitout);
}

void GlossaryDialog::next() {
    const int end = m_document.operationCount();
    if (m_document.step() >= end) {
        m_document.setStep(m_entries[static_cast<std::size_t>(m_row)].from);
        m_timer.start(kOperationMs / 2);
    } else {
        m_document.moveStep(+1);
        m_timer.start(m_document.step() >= end ? kOperationMs + kRestMs : kOperationMs);
    }
}

} // namespace knittsim::ui
