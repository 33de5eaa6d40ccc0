// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QObject>
#include <QString>
#include <functional>

class QImage;
class QWidget;

namespace quadrille {

struct EditorContext;

namespace widgets {
class Viewport;
}

/// Takes the picture of the viewport in front as it is: onto the clipboard, or into a file.
class PictureFlow : public QObject
{
    Q_OBJECT
public:
    using ViewportInFront = std::function<widgets::Viewport*()>;

    /// \param viewport  null when there is none.
    PictureFlow(EditorContext& context, ViewportInFront viewport, QWidget* window);

    /// Draws the picture and writes it in a job. `saved` tells when it is written; what fails goes to the
    /// issues. \param file  PNG, JPEG or TIFF by its ending.
    void save(const QString& file);

signals:
    void saved(const QStringList& files);

private:
    void copy();
    void askAndSave();

    EditorContext& m_context;
    QImage picture() const;

    ViewportInFront m_viewport;
    QWidget* m_window;
    QString m_folder; ///< of the picture saved last
};

} // namespace quadrille
