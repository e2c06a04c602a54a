// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Drives the blend shapes of meshes by a mouth table.</summary>
    [AddComponentMenu("Phoneme Ear/Talking Face")]
    public sealed class TalkingFace : EarListener
    {
        /// <summary>A blend shape that a movestate moves, where it has another name.</summary>
        [Serializable]
        public struct AssignedShape
        {
            public string movestate, blendShape;
        }

        [Tooltip("Meshes with blend shapes of the table's names, or such as end in them after a dot")]
        public SkinnedMeshRenderer[] faces = new SkinnedMeshRenderer[0];

        [Tooltip("Weight of a whole movement; 100 unless the mesh has other weights"), Range(0, 200)]
        public float strength = 100;

        [Tooltip("Blend shapes with other names; Window > Phoneme Ear assigns them")]
        public AssignedShape[] shapes = new AssignedShape[0];

        private Mouth mouth;
        private float[] weights;
        private readonly List<SkinnedMeshRenderer> moved = new List<SkinnedMeshRenderer>();
        private readonly List<int[]> targets = new List<int[]>(); // of each, for each movestate: the blend shape, or -1

        protected override string UsualTable => "arkit";

        /// <summary>The number of the blend shape for a movestate, or -1: the assigned one, or that of its name.</summary>
        public static int TargetOf(Mesh mesh, string movestate, AssignedShape[] shapes)
        {
            foreach (var shape in shapes)
                if (shape.movestate == movestate)
                    movestate = shape.blendShape;
            for (var k = 0; k < mesh.blendShapeCount; k++)
            {
                var name = mesh.GetBlendShapeName(k);
                if (name == movestate || name.EndsWith("." + movestate, StringComparison.Ordinal))
                    return k;
            }
            return -1;
        }

        protected override void Begin()
        {
            mouth = new Mouth(Model, TableNumber);
            weights = new float[mouth.Movestates.Count];
            moved.Clear();
            targets.Clear();
            foreach (var face in faces)
            {
                if (!face || !face.sharedMesh)
                    continue; // an empty slot
                var found = new int[weights.Length];
                for (var k = 0; k < found.Length; k++)
                    found[k] = TargetOf(face.sharedMesh, mouth.Movestates[k], shapes);
                moved.Add(face);
                targets.Add(found);
                if (Array.TrueForAll(found, target => target < 0))
                    Debug.LogWarning($"{face.name}: it has no blend shape of the table {TableName}, such as {mouth.Movestates[0]}", this);
            }
        }

        protected override void End()
        {
            if (mouth == null)
                return;
            Move(0); // or the mouth would stay as it was
            mouth.Dispose();
            mouth = null;
        }

        protected override void Hear(in Frame frame) => mouth?.Hear(frame.Time, frame);

        protected override void Update()
        {
            base.Update();
            if (mouth == null)
                return;
            mouth.Weights(Newest.Time, weights);
            Move(strength);
        }

        private void Move(float whole)
        {
            for (var k = 0; k < moved.Count; k++)
                for (var state = 0; state < weights.Length; state++)
                    if (targets[k][state] >= 0 && moved[k])
                        moved[k].SetBlendShapeWeight(targets[k][state], whole * weights[state]);
        }
    }
}
