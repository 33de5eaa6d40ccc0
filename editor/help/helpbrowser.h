// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QTextBrowser>

namespace quadrille {

/// A text browser whose pictures are as wide as its text.
class HelpBrowser : public QTextBrowser
{
    Q_OBJECT

public:
    using QTextBrowser::QTextBrowser;

protected:
    QVariant loadResource(int type, const QUrl& name) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    int textWidth() const;

    int m_pictureWidth = 0; ///< of the pictures that are shown
};

} // namespace quadrille
