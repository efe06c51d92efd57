function name = file_of(name)
% FILE_OF  Returns a file name for the command, which would take a name that begins with - for an option.
if ~isempty(name) && name(1) == '-'
    name = ['./' name];
end
end
