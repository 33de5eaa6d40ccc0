// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#pragma once

#include "editor/properties/propertyform.h"

class QLineEdit;
class QPlainTextEdit;

namespace quadrille {

class TextureField;
struct EditorContext;

/// A character: its mesh, its textures, what is to be said about it, and how its surface hangs together.
class CharacterPage : public PropertyForm
{
    Q_OBJECT

public:
    explicit CharacterPage(EditorContext& context);
    void show(const QString& name) override;

private:
    void showSurface();

    EditorContext& m_context;
    QString m_name;
    QLineEdit* m_nameField;
    QLabel* m_mesh;
    TextureField* m_texture;
    QLabel* m_surface;
    QLabel* m_sequences;
    QPlainTextEdit* m_notes;
};

} // namespace quadrille
