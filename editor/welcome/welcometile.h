// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include <QAbstractButton>

namespace quadrille {

/// A large button with a sign, a name and a sentence. While what it started is on its way, it shows how far
/// that is.
class WelcomeTile : public QAbstractButton
{
    Q_OBJECT

public:
    explicit WelcomeTile(const QString& icon, QWidget* parent = nullptr);

    /// \param sentence may be wrapped into several lines.
    void setTexts(const QString& name, const QString& sentence);
    /// \param fraction 0 … 1. \param sentence in the place of the usual one.
    void showProgress(double fraction, const QString& sentence);
    void endProgress();
    bool isInProgress() const { return m_fraction >= 0; }
    /// Negative while nothing is on its way.
    double fraction() const { return m_fraction; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QFont nameFont() const;
    QRect textRect(int width) const;
    const QString& sentence() const { return isInProgress() ? m_progressSentence : m_sentence; }
    void paintProgress(QPainter& painter) const;

    QString m_icon;
    QString m_sentence;
    QString m_progressSentence;
    double m_fraction = -1; ///< negative while nothing is on its way
};

} // namespace quadrille
