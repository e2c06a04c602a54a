// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Shows the drawing of a mouth that goes with what is recognised.</summary>
    [RequireComponent(typeof(SpriteRenderer)), AddComponentMenu("Phoneme Ear/Talking Sprite")]
    public sealed class TalkingSprite : EarListener
    {
        [Serializable]
        public struct Drawing
        {
            [Tooltip("A shape of the table, such as B")] public string shape;
            public Sprite sprite;
        }

        public Drawing[] drawings = new Drawing[0];

        private readonly Dictionary<int, Sprite> sprites = new Dictionary<int, Sprite>();
        private SpriteRenderer mouth;

        protected override string UsualTable => "rhubarb";

        protected override void Begin()
        {
            mouth = GetComponent<SpriteRenderer>();
            sprites.Clear();
            var shapes = new List<string>(Model.Shapes(TableNumber));
            foreach (var drawing in drawings)
                if (shapes.Contains(drawing.shape))
                    sprites[shapes.IndexOf(drawing.shape)] = drawing.sprite;
                else
                    Debug.LogWarning($"the table {TableName} has no shape {drawing.shape}; it has {string.Join(", ", shapes)}", this);
        }

        protected override void End() { }

        protected override void Hear(in Frame frame)
        {
            if (sprites.TryGetValue(Model.ShapeOf(TableNumber, frame), out var sprite))
                mouth.sprite = sprite;
        }
    }
}
