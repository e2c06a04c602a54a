// SPDX-License-Identifier: MIT
using UnityEngine;
using UnityEngine.Playables;

namespace PhonemeEar
{
    /// <summary>Sets the weights of a mesh while a CurvesClip plays, and lets them go at its end.</summary>
    public sealed class CurvesBehaviour : PlayableBehaviour
    {
        private static readonly TalkingFace.AssignedShape[] Nothing = new TalkingFace.AssignedShape[0];

        private SkinnedMeshRenderer face;
        private int[] targets;

        internal Curves Curves;
        internal float Strength;

        public override void ProcessFrame(Playable playable, FrameData info, object playerData)
        {
            Bind(playerData as SkinnedMeshRenderer);
            Move(playable.GetTime(), info.weight);
        }

        public override void OnBehaviourPause(Playable playable, FrameData info) => Move(0, 0);

        private void Bind(SkinnedMeshRenderer bound)
        {
            if (bound == face)
                return;
            face = bound;
            targets = new int[Curves.curves.Length];
            for (var k = 0; face && k < targets.Length; k++)
                targets[k] = face.sharedMesh ? TalkingFace.TargetOf(face.sharedMesh, Curves.curves[k].name, Nothing) : -1;
        }

        private void Move(double time, float weight)
        {
            for (var k = 0; face && k < targets.Length; k++)
                if (targets[k] >= 0)
                    face.SetBlendShapeWeight(targets[k], Strength * weight * Curves.At(Curves.curves[k], time));
        }
    }
}
