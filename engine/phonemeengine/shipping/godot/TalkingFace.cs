// SPDX-License-Identifier: MIT
using Godot;

namespace PhonemeEar
{
    /// <summary>Drives the blend shapes of a mesh by a mouth table.</summary>
    [GlobalClass]
    public partial class TalkingFace : EarListener
    {
        /// <summary>A mesh with blend shapes of the table's names.</summary>
        [Export] public MeshInstance3D Face;

        /// <summary>A mouth table that was shipped with the preset.</summary>
        [Export] public string Table = "arkit";

        private Mouth mouth;
        private float[] weights;
        private int[] targets; // for each movestate: the blend shape, or -1

        public override string TableName => Table;

        public override void _ExitTree()
        {
            mouth?.Dispose();
            mouth = null;
            base._ExitTree();
        }

        public override void _Process(double delta)
        {
            base._Process(delta);
            mouth.Weights(Newest.Time, weights);
            for (var k = 0; k < weights.Length; k++)
                if (targets[k] >= 0)
                    Face.SetBlendShapeValue(targets[k], weights[k]);
        }

        protected override void Hear(in Frame frame) => mouth.Hear(frame.Time, frame);

        protected override void Begin()
        {
            if (Face == null)
                throw new EarException("it has no face; choose a MeshInstance3D with blend shapes");
            mouth = new Mouth(Model, TableNumber);
            weights = new float[mouth.Movestates.Count];
            targets = new int[weights.Length];
            var found = false;
            for (var k = 0; k < targets.Length; k++)
                found |= (targets[k] = Face.FindBlendShapeByName(mouth.Movestates[k])) >= 0;
            if (!found)
                GD.PushWarning($"{Face.Name}: it has no blend shape of the table {Table}, such as {mouth.Movestates[0]}");
        }
    }
}
