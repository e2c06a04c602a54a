// SPDX-License-Identifier: MIT
using PhonemeEar;
using UnityEngine;

/// <summary>Has a head speak by the microphone that is made while the game runs: put it on the head.</summary>
public sealed class TalkAtRunTime : MonoBehaviour
{
    public TextAsset preset; // preset.bytes of the package

    private void Start()
    {
        var face = gameObject.AddComponent<TalkingFace>();
        face.preset = preset;
        face.microphone = true;
        face.faces = GetComponentsInChildren<SkinnedMeshRenderer>();
    }
}
