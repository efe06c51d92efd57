function name = file_of(name)
% FILE_OF  Returns a file name for the command, so that a name that begins with - is not taken for an option.
if ~isempty(name) && name(1) == '-'
    name = ['./' name];
end
end
