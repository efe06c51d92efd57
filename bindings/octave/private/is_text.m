function yes = is_text(value)
% IS_TEXT  Returns true if a value is one line of characters.
yes = ischar(value) && size(value, 1) == 1 && ~isempty(value);
end
