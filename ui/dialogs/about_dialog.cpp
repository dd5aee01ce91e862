#include "ui/dialogs/about_dialog.h"

#include "ui/views/style/icons.h"

#include <QClipboard>
#include <QDialogButtonBox>
#include <QGuiApplication>
#include <QLabel>
#include <QPushButton>
#include <QSysInfo>
#include <QVBoxLayout>

namespace knittsim::ui {

QString AboutDialog::facts(const QString& renderer) {
    QStringList lines;
    lines << tr("KnittSim %1").arg(QStringLiteral(KNITTSIM_VERSION));
    lines << tr("Qt %1 (built with %2)").arg(QString::fromLatin1(qVersion()), QStringLiteral(QT_VERSION_STR));
    lines << tr("OpenGL: %1").arg(renderer.isEmpty() ? tr("not in use") : renderer);
    lines << tr("System: %1, %2").arg(QSysInfo::prettyProductName(), QSysInfo::currentCpuArchitecture());
    return lines.join(u'\n');
}

AboutDialog::AboutDialog(const QString& renderer, QWidget* parent) : QDialog(parent) {
    setObjectName(QStringLiteral("aboutDialog"));
    setWindowTitle(tr("About KnittSim"));
    auto* picture = new QLabel(this);
    picture->setPixmap(applicationIcon().pixmap(QSize(72, 72), devicePixelRatioF()));
    auto* text = new QLabel(facts(renderer), this);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto* purpose =
        new QLabel(tr("Turns knitting-machine programs into the fabric they knit, after the method of "
                      "Mei\u00dfner and Eberhardt, \u201cThe Art of Knitted Fabrics\u201d (1998).\n\n"
                      "MIT licence. Copyright the KnittSim authors."),
                   this);
    purpose->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    QPushButton* copy = buttons->addButton(tr("Copy"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copies these lines for a report"));
    connect(copy, &QPushButton::clicked, this,
            [renderer] { QGuiApplication::clipboard()->setText(facts(renderer)); });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* words = new QVBoxLayout;
    words->setSpacing(12);
    words->addWidget(text);
    words->addWidget(purpose);
    auto* row = new QHBoxLayout;
    row->setSpacing(18);
    row->addWidget(picture, 0, Qt::AlignTop);
    row->addLayout(words, 1);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(20, 20, 20, 14);
    rows->setSpacing(16);
    rows->addLayout(row);
    rows->addWidget(buttons);
    setMinimumWidth(480);
}

} // namespace knittsim::ui
