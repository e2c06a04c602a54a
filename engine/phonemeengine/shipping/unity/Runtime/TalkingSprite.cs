// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Shows the drawing of a mouth that goes with what is heard.</summary>
    [RequireComponent(typeof(SpriteRenderer))]
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

        private void Reset() => table = "rhubarb";

        protected override void OnEnable()
        {
            base.OnEnable();
            if (Model == null)
                return;
            mouth = GetComponent<SpriteRenderer>();
            var shapes = new List<string>(Model.Shapes(TableNumber));
            foreach (var drawing in drawings)
                if (shapes.Contains(drawing.shape))
                    sprites[shapes.IndexOf(drawing.shape)] = drawing.sprite;
                else
                    Debug.LogWarning($"the table {table} has no shape {drawing.shape}; it has {string.Join(", ", shapes)}", this);
        }

        protected override void Hear(in Frame frame)
        {
            if (sprites.TryGetValue(Model.ShapeOf(TableNumber, frame), out var sprite))
                mouth.sprite = sprite;
        }
    }
}
