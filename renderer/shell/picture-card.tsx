import { Icon } from '../ui/icon.tsx';

interface PictureCardProps {
  /** Said before the title to those who do not see where the card is. */
  readonly purpose?: string;
  readonly title: string;
  readonly text?: string;
  readonly picture: string | undefined;
  readonly disabled: boolean;
  readonly onPress: () => void;
}

/** Something to begin with, by its picture. */
export function PictureCard({ purpose, title, text, picture, disabled, onPress }: PictureCardProps) {
  return (
    <button type="button" className="picture-card" disabled={disabled} onClick={onPress}>
      {picture === undefined ? (
        <span className="picture-card-none">
          <Icon name="image" size={24} />
        </span>
      ) : (
        <img src={picture} alt="" width={240} height={180} draggable={false} />
      )}
      <span className="picture-card-title">
        {purpose !== undefined && <span className="visually-hidden">{purpose}: </span>}
        {title}
      </span>
      {text !== undefined && <span className="picture-card-text">{text}</span>}
    </button>
  );
}
