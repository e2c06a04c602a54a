// Guesses by the shipped C#, for tests: Guess.exe SHAPE_NAMES MOVESTATES NAMES, lists separated by commas; a line for each.

using System;
using System.IO;
using PhonemeEar;

public static class Guess
{
    public static void Main(string[] words)
    {
        var guess = new ShapeGuess(File.ReadAllText(words[0]));
        foreach (var movestate in words[1].Split(','))
            Console.WriteLine(guess.For(movestate, words[2].Split(',')));
    }
}
