// SPDX-License-Identifier: MIT
using System.Collections.Generic;
using Godot;

namespace PhonemeEar
{
    /// <summary>Shows the drawing of a mouth that goes with what is recognised: the animation of its shape's name.</summary>
    [GlobalClass]
    public partial class TalkingSprite : EarListener
    {
        /// <summary>A sprite with an animation for each shape of the table, such as B.</summary>
        [Export] public AnimatedSprite2D Sprite;

        /// <summary>A mouth table that was shipped with the preset.</summary>
        [Export] public string Table = "rhubarb";

        private IReadOnlyList<string> shapes;

        public override string TableName => Table;

        protected override void Hear(in Frame frame)
        {
            var shape = shapes[Model.ShapeOf(TableNumber, frame)];
            if (Sprite.SpriteFrames.HasAnimation(shape))
                Sprite.Animation = shape;
        }

        protected override void Begin()
        {
            if (Sprite == null)
                throw new EarException("it has no sprite; choose an AnimatedSprite2D");
            shapes = Model.Shapes(TableNumber);
        }
    }
}
