// SPDX-License-Identifier: MIT
using System.Collections.Generic;
using UnityEngine;

namespace PhonemeEar
{
    /// <summary>Drives the blend shapes of meshes by a mouth table.</summary>
    public sealed class TalkingFace : EarListener
    {
        [Tooltip("Meshes with blend shapes of the table's names, or such as end in them after a dot")]
        public SkinnedMeshRenderer[] faces = new SkinnedMeshRenderer[0];

        [Tooltip("Weight of a whole movement; 100 unless the mesh has other weights"), Range(0, 200)]
        public float strength = 100;

        private Mouth mouth;
        private float[] weights;
        private List<int>[] targets; // of each face, for each movestate: the blend shape, or -1

        private void Reset() => table = "arkit";

        protected override void OnEnable()
        {
            base.OnEnable();
            if (Model == null)
                return;
            mouth = new Mouth(Model, TableNumber);
            weights = new float[mouth.Movestates.Count];
            targets = new List<int>[faces.Length];
            for (var k = 0; k < faces.Length; k++)
                targets[k] = TargetsOf(faces[k].sharedMesh);
        }

        protected override void OnDisable()
        {
            mouth?.Dispose();
            mouth = null;
            base.OnDisable();
        }

        protected override void Hear(in Frame frame) => mouth?.Hear(frame.Time, frame);

        protected override void Update()
        {
            base.Update();
            if (mouth == null)
                return;
            mouth.Weights(Newest.Time, weights);
            for (var k = 0; k < faces.Length; k++)
                for (var state = 0; state < weights.Length; state++)
                    if (targets[k][state] >= 0)
                        faces[k].SetBlendShapeWeight(targets[k][state], strength * weights[state]);
        }

        private List<int> TargetsOf(Mesh mesh)
        {
            var found = new List<int>();
            foreach (var movestate in mouth.Movestates)
                found.Add(TargetOf(mesh, movestate));
            if (found.TrueForAll(target => target < 0))
                Debug.LogWarning($"{mesh.name}: it has no blend shape of the table {table}, such as {mouth.Movestates[0]}", this);
            return found;
        }

        private static int TargetOf(Mesh mesh, string movestate)
        {
            for (var k = 0; k < mesh.blendShapeCount; k++)
            {
                var name = mesh.GetBlendShapeName(k);
                if (name == movestate || name.EndsWith("." + movestate))
                    return k;
            }
            return -1;
        }
    }
}
