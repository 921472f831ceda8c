// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#include "ui/widgets/filesheet.h"

#include "ui/widgets/question.h"
#include <QDir>
#include <QFileInfo>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(FileSheet)
};

/// What QFileDialog says in modal boxes of its own is said here in sheets, and before it can say it.
class PathDialog : public QFileDialog
{
public:
    PathDialog(const PathQuestion &question, QWidget *parent) : QFileDialog(parent), m_kind {question.kind}
    {
        setObjectName(QLatin1String(question.name));
        setOptions(DontUseNativeDialog | DontConfirmOverwrite | ReadOnly);
        setAcceptMode(m_kind == PathKind::NewFile ? AcceptSave : AcceptOpen);
        setFileMode(m_kind == PathKind::OldFile ? ExistingFile : m_kind == PathKind::Folder ? Directory : AnyFile);
        setOption(ShowDirsOnly, m_kind == PathKind::Folder);
        if (!question.filters.isEmpty())
            setNameFilters(question.filters);
        setDefaultSuffix(question.suffix);
        begin(question.begin);
        for (auto *button : findChildren<QPushButton *>())
            button->setAutoDefault(false);
    }

    void accept() override
    {
        const QStringList chosen = selectedFiles();
        if (chosen.isEmpty())
            return;
        const QFileInfo path {chosen.first()};
        if (m_kind != PathKind::Folder && path.isDir())
            return setDirectory(path.filePath());
        if (m_kind != PathKind::NewFile && !path.exists())
            return tell(Words::tr("There is no “%1”.").arg(QDir::toNativeSeparators(path.filePath())));
        if (!path.dir().exists())
            return tell(Words::tr("There is no folder “%1”.").arg(QDir::toNativeSeparators(path.path())));
        if (m_kind == PathKind::NewFile && path.exists())
            return askToReplace(path);
        done(Accepted);
    }

private:
    void begin(const QString &path)
    {
        const QFileInfo info {path};
        if (path.isEmpty())
            return;
        setDirectory(info.isDir() ? path : info.path());
        if (!info.isDir())
            selectFile(info.fileName());
    }
    void tell(const QString &text) { ask("fileMessage", windowTitle(), text, {}, this); }
    void askToReplace(const QFileInfo &path)
    {
        const QString text = Words::tr("“%1” exists already. Is it to be replaced?").arg(path.fileName());
        ask("replaceFile", windowTitle(), text,
            {{"confirmReplaceFile", Words::tr("Replace"), [this] { done(Accepted); }}}, this);
    }

    PathKind m_kind;
};

} // namespace

QFileDialog *askForPath(
    const PathQuestion &question, QWidget *owner, const std::function<void(const QString &path)> &then)
{
    auto *sheet = new DialogSheet(owner);
    sheet->setObjectName(QStringLiteral("fileSheet"));
    sheet->setWindowTitle(question.title);
    auto *dialog = new PathDialog(question, sheet);
    dialog->setWindowTitle(question.title);
    dialog->setWindowFlags(Qt::Widget);
    auto *column = new QVBoxLayout(sheet);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(dialog);
    sheet->resize(760, 460);
    QObject::connect(dialog, &QDialog::finished, sheet, [sheet, dialog, then](int result) {
        if (sheet->isAnswered())
            return;
        const QStringList chosen = dialog->selectedFiles();
        sheet->done(result);
        if (result == QDialog::Accepted && !chosen.isEmpty())
            then(chosen.first());
    });
    dialog->show();
    sheet->show();
    return dialog;
}

} // namespace widgets
