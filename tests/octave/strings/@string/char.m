function characters = char(text)
characters = text.characters;
end
